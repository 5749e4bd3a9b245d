//! The hashes are those that all machines have found.

use catena_same_bits::{NAMES, controlled, hashes};

/// After 500 steps. Those of more steps, and of other machines, are compared by `everywhere.sh`.
const RECORDED: [u64; 6] = [
    0xa934_69be_26ca_10d1,
    0xe420_422d_cf8f_0a8a,
    0x6857_3cca_11bc_ceae,
    0xcd48_86ea_f5dd_fd10,
    0x3dbd_9ab0_f700_6fb1,
    0xb07c_82d1_6583_a2b8,
];
/// Under error control, over ten seconds.
const CONTROLLED: u64 = 0x26b4_d19b_4a60_8653;

#[test]
fn motions_have_the_bits_of_all_machines() -> Result<(), catena::Error> {
    for ((name, found), recorded) in NAMES.iter().zip(hashes(500)?).zip(RECORDED) {
        assert_eq!(found, recorded, "{name}: {found:#x} instead of {recorded:#x}");
    }
    let found = controlled(10.0)?;
    assert_eq!(found, CONTROLLED, "error control: {found:#x} instead of {CONTROLLED:#x}");
    Ok(())
}

#[cfg(feature = "lanes")]
#[test]
fn lanes_have_the_bits_of_plain_numbers() -> Result<(), catena::Error> {
    for ((name, lanes), plain) in NAMES.iter().zip(catena_same_bits::hashes_in_lanes(500)?).zip(hashes(500)?) {
        assert_eq!(lanes, [plain; 4], "{name}");
    }
    Ok(())
}
