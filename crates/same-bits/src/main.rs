//! Prints the hashes of six scenes and the time that they take: `same-bits [STEPS]`, 100 000 without a number.

fn main() -> Result<(), catena::Error> {
    let steps = std::env::args().nth(1).and_then(|word| word.parse().ok()).unwrap_or(100_000);
    let start = std::time::Instant::now();
    let hashes = catena_same_bits::hashes(steps)?;
    let seconds = start.elapsed().as_secs_f64();
    for (name, hash) in catena_same_bits::NAMES.iter().zip(hashes) {
        println!("{hash:016x}  {name}");
    }
    println!("{:016x}  steps under error control", catena_same_bits::controlled(10.0)?);
    #[cfg(feature = "lanes")]
    for (lanes, hash) in catena_same_bits::hashes_in_lanes(steps)?.iter().zip(hashes) {
        if lanes.iter().any(|lane| *lane != hash) {
            println!("lanes differ: {lanes:x?} for {hash:x}");
        }
    }
    eprintln!("{steps} steps: {seconds:.2} s");
    Ok(())
}
