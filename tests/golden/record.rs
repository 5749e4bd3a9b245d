//! Bits of motions and forces by the name of a scene, as a text.

use catena::internals::relation::Closures;
use catena::system::{Position, Rate};
use catena::{Motion, Scalar};
use std::fmt::Write;

/// What is recorded of a scene, line by line.
const PARTS: [&str; 4] = ["positions", "rates", "accelerations", "forces"];

/// The scenes recorded so far.
#[derive(Default)]
pub struct Record(Vec<(&'static str, [Vec<u64>; 4])>);

/// A number whose bits are known.
pub trait Bits: Scalar {
    fn bits(self) -> u64;
}
impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }
}
impl Bits for f32 {
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

/// Internal force and torque at a station.
pub trait Internal<T> {
    fn numbers(&self) -> Vec<T>;
}
impl<T: Scalar> Internal<T> for catena::planar::Station<T> {
    fn numbers(&self) -> Vec<T> {
        vec![self.internal.force.x, self.internal.force.y, self.internal.torque]
    }
}
impl<T: Scalar> Internal<T> for catena::spatial::Station<T> {
    fn numbers(&self) -> Vec<T> {
        [self.internal.force, self.internal.torque].map(|v| [v.x, v.y, v.z]).concat()
    }
}

/// The bits of finite numbers.
fn words<T: Bits>(name: &str, numbers: Vec<T>) -> Vec<u64> {
    assert!(numbers.iter().all(|x| x.is_finite()), "{name} is not finite");
    numbers.into_iter().map(Bits::bits).collect()
}

impl Record {
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Adds a scene: its motion after a run, forces and torques at its stations.
    pub fn add<T: Bits, P: Position<T>, C: Closures>(
        &mut self,
        name: &'static str,
        motion: &Motion<T, P, C>,
        forces: Vec<T>,
    ) {
        let [mut positions, mut rates, mut accelerations] = [const { Vec::new() }; 3];
        motion.position().visit(&mut |x| positions.push(x.bits()));
        motion.rate().visit(&mut |x| rates.push(x.bits()));
        motion.acceleration().visit(&mut |x| accelerations.push(x.bits()));
        let forces = words(name, forces);
        self.0.push((name, [positions, rates, accelerations, forces]));
    }

    /// Adds numbers of a formulation without a motion: its states, which hold forces.
    pub fn add_numbers(&mut self, name: &'static str, states: Vec<f64>) {
        let states = words(name, states);
        self.0.push((name, [vec![], vec![], vec![], states]));
    }

    /// A line for each part of each scene.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for (name, parts) in &self.0 {
            for (part, words) in PARTS.iter().zip(parts) {
                let words: Vec<String> = words.iter().map(|word| format!("{word:x}")).collect();
                let _ = writeln!(text, "{name}, {part}: {}", words.join(" "));
            }
        }
        text
    }

    /// What has changed, or come, or gone, by name.
    pub fn differences(&self, recorded: &str) -> Vec<String> {
        let text = self.text();
        let (now, then): (Vec<&str>, Vec<&str>) = (text.lines().collect(), recorded.lines().collect());
        let name = |line: &str| line.split(':').next().unwrap_or_default().to_owned();
        let mut found = vec![];
        for line in now.iter().filter(|line| !then.contains(*line)) {
            let before = then.iter().find(|old| name(old) == name(line));
            found.push(match before {
                Some(before) => format!("{}: {}", name(line), farthest(line, before)),
                None => format!("{}: not recorded", name(line)),
            });
        }
        for line in then.iter().filter(|old| !now.iter().any(|line| name(line) == name(old))) {
            found.push(format!("{}: recorded, but gone", name(line)));
        }
        found
    }
}

/// The numbers of two lines that are farthest apart.
fn farthest(line: &str, before: &str) -> String {
    let words = |line: &str| -> Vec<u64> {
        let words = line.split(": ").nth(1).unwrap_or_default().split_whitespace();
        words.filter_map(|word| u64::from_str_radix(word, 16).ok()).collect()
    };
    let (now, then) = (words(line), words(before));
    if now.len() != then.len() {
        return format!("{} numbers instead of {}", now.len(), then.len());
    }
    let number =
        |bits: u64| if bits >> 32 == 0 { f64::from(f32::from_bits(bits as u32)) } else { f64::from_bits(bits) };
    let pairs = now.iter().zip(&then).map(|(a, b)| (number(*a), number(*b)));
    let (a, b) = pairs.fold((0.0, 0.0), |w: (f64, f64), p| if (p.0 - p.1).abs() > (w.0 - w.1).abs() { p } else { w });
    format!("{a:e} instead of {b:e}")
}

#[test]
fn a_changed_bit_is_found_and_named() {
    let record = Record(vec![("a scene", [vec![1_f64.to_bits()], vec![], vec![], vec![]])]);
    let text = record.text();
    assert!(record.differences(&text).is_empty());
    let changed = text.replace(&format!("{:x}", 1_f64.to_bits()), &format!("{:x}", 1_f64.next_up().to_bits()));
    assert_eq!(record.differences(&changed).len(), 1);
    assert!(record.differences(&changed)[0].starts_with("a scene, positions: 1e0 instead of 1.0000000000000002e0"));
    assert_eq!(record.differences(&(text + "another, rates: 1\n")), ["another, rates: recorded, but gone"]);
}
