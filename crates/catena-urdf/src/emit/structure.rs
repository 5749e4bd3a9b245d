//! What of a robot's numbers is zero, and which turns are quarters: the types of its elements in body axes.

use super::{list, number};
use crate::algebra::{IDENTITY, Matrix, Vector, cross, dot, matrix, scale, vector};
use crate::inertia::Inertia;
use crate::robot::{Body, Robot};

/// Below this share of the largest number of its kind a number is rounding of what made it.
const ROUNDED: f64 = 32.0 * f64::EPSILON;

/// A joint as the library's type and value, without its name and place.
pub struct Joint {
    /// Bits of the place that are there.
    pub mask: u8,
    pub place: Vector,
    /// Type of the turn.
    pub offset: String,
    /// Methods that make it, if there is one.
    pub turned: String,
}

/// Numbers of a list that count, and their bits.
fn masked<const N: usize>(numbers: [f64; N], general: bool) -> ([f64; N], u8) {
    let most = numbers.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let kept = numbers.map(|x| if x.abs() <= ROUNDED * most { 0.0 } else { x });
    let bits = (0..N).filter(|bit| general || kept[*bit] != 0.0).map(|bit| 1 << bit).sum();
    (kept, bits)
}

/// The number of a signed coordinate axis: 0 to 2 for x, y, z, 3 to 5 for their opposites.
fn direction(column: Vector) -> Option<u8> {
    let along = |k: usize| (0..3).all(|i| i == k || column[i] == 0.0) && column[k].abs() == 1.0;
    (0..3).find(|k| along(*k)).map(|k| if column[k] > 0.0 { k as u8 } else { k as u8 + 3 })
}

pub fn joint(body: &Body, general: bool) -> Joint {
    let (place, mask) = masked(body.pose.place, general);
    let (turn, angle) = if general || body.slides { (body.pose.turn, 0.0) } else { ahead(&body.pose.turn) };
    let column = |k: usize| vector(|i| turn[i][k]);
    let quarter = direction(column(0)).zip(direction(column(1))).map(|(x, y)| x + 6 * y);
    let (offset, turned) = match quarter {
        _ if general => ("Turned<T>".to_owned(), full(&turn)),
        _ if turn == IDENTITY => ("Level".to_owned(), String::new()),
        Some(code) => (format!("Quarter<{code}>"), format!("Quarter::<{code}>")),
        None => match known(&turn) {
            (turn, 0) => ("Turned<T>".to_owned(), full(&turn)),
            (turn, code) => (format!("Turned<T, {code}>"), format!("{}.known::<{code}>()", full(&turn))),
        },
    };
    let turned = if turned.is_empty() { turned } else { format!(".turned({turned})") };
    match angle {
        0.0 => Joint { mask, place, offset, turned },
        _ => Joint {
            mask,
            place,
            offset: format!("Ahead<T, {offset}>"),
            turned: format!("{turned}.ahead(T::literal({}))", number(angle)),
        },
    }
}

/// The turn of a hinge as one of fewer numbers, and one by an angle (rad) about z after it. The first has one of the parent's axes as its x or y
/// where the axis of the hinge is in a plane of the two others.
fn ahead(turn: &Matrix) -> (Matrix, f64) {
    let column = |k: usize| vector(|i| turn[i][k]);
    let z = column(2).map(|x| if x.abs() <= ROUNDED { 0.0 } else { x });
    let z = scale(1.0 / dot(z, z).sqrt(), z);
    let level = (0..3).filter(|k| z[*k] == 0.0);
    let units = level.flat_map(|k| [1.0, -1.0].map(|sign| vector(|i| if i == k { sign } else { 0.0 })));
    let turns = units.flat_map(|unit| {
        let (as_x, as_y) = ([unit, cross(z, unit), z], [cross(unit, z), unit, z]);
        [as_x, as_y].map(|columns| matrix(|i, k| columns[k][i]))
    });
    let angle = |first: &Matrix| {
        let [x, y] = [0, 1].map(|k| vector(|i| first[i][k]));
        dot(column(0), y).atan2(dot(column(0), x))
    };
    let least = turns.map(|first| (first, angle(&first))).min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
    match least {
        Some((first, angle)) => (first, if angle.abs() > ROUNDED { angle } else { 0.0 }),
        None => (*turn, 0.0),
    }
}

/// A turn without what is rounding of zeros and ones, and what is known of its entries: two bits for each, row by row.
fn known(turn: &Matrix) -> (Matrix, u32) {
    let near = |x: f64, y: f64| (x - y).abs() <= ROUNDED;
    let alone =
        |i: usize, k: usize| (0..3).all(|m| (m == k || near(turn[i][m], 0.0)) && (m == i || near(turn[m][k], 0.0)));
    let entry = |i: usize, k: usize| match turn[i][k] {
        x if near(x, 0.0) => (0.0, 1),
        x if near(x, 1.0) && alone(i, k) => (1.0, 2),
        x if near(x, -1.0) && alone(i, k) => (-1.0, 3),
        x => (x, 0),
    };
    let code = (0..9).rev().fold(0, |code, at| code << 2 | entry(at / 3, at % 3).1);
    (matrix(|i, k| entry(i, k).0), code)
}

/// Axes of a turn.
fn full(turn: &Matrix) -> String {
    let column = |k: usize| list(vector(|i| turn[i][k]));
    format!("Turned::axes(tensor([{}, {}, {}]))", column(0), column(1), column(2))
}

/// Bits of first moment and tensor about the origin.
pub fn masks(inertia: &Inertia, general: bool) -> [u8; 2] {
    let Inertia { mass, centre, tensor } = inertia;
    let about = matrix(|i, k| {
        let square = if i == k { dot(*centre, *centre) } else { 0.0 };
        tensor[i][k] + mass * (square - centre[i] * centre[k])
    });
    let list = [about[0][0], about[1][1], about[2][2], about[1][2], about[0][2], about[0][1]];
    [masked(centre.map(|x| x * mass), general).1, masked(list, general).1]
}

/// A body's element.
pub fn link(inertia: &Inertia) -> String {
    let Inertia { mass, centre, tensor } = inertia;
    let [x, y, z] = tensor.map(list);
    let mass = number(*mass);
    format!(
        "Link::new(\n            T::literal({mass}),\n            vector({}),\n            tensor([{x}, {y}, {z}]),\n        )",
        list(*centre)
    )
}

/// Whether some joint has a turn of any, of a quarter, none, and one about its own axis.
pub fn kinds(robot: &Robot, general: bool) -> [bool; 4] {
    let is = |name: &str| robot.bodies.iter().any(|body| joint(body, general).offset.contains(name));
    [is("Turned"), is("Quarter"), is("Level"), is("Ahead")]
}
