//! The hashes are those that all machines have found.

use catena_same_bits::{NAMES, controlled, hashes};

/// After 500 steps. Those of more steps, and of other machines, are compared by `everywhere.sh`.
const RECORDED: [u64; 6] = [
    0x5c76_4aa1_d4f3_fe6a,
    0xe420_422d_cf8f_0a8a,
    0x61ff_9514_7313_5b6f,
    0xb095_2c22_eb45_cf3d,
    0xaafc_5b93_bbb6_9fa9,
    0xc26f_37cf_c6a4_e65c,
];
/// Under error control, over ten seconds.
const CONTROLLED: u64 = 0x700e_b74f_70ad_6e40;

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
