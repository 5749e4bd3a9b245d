//! Moments of inertia in lanes, each of which is checked by its own size: what one lane refuses is refused beside any others.

use catena::Fault;
use catena::scalar::{Scalar, WideF32x8, WideF64x4};
use catena::spatial::{Inertia, RigidBody};
use catena::{planar, robot, spatial};

type Tensor = [[f64; 3]; 3];

/// Numbers of a generator, in (−1, 1).
fn numbers(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A tensor of any size and attitude, sometimes that of a body, sometimes with a negative moment, sometimes askew.
fn tensor(next: &mut impl FnMut() -> f64) -> Tensor {
    let size = 10_f64.powf(6.0 * next());
    let moments: [f64; 3] = core::array::from_fn(|_| next() + 0.8);
    let turn = spatial::Rotation::exp([0; 3].map(|_| 2.0 * next())).matrix();
    let rows: [[f64; 3]; 3] = core::array::from_fn(|i| [turn.x[i], turn.y[i], turn.z[i]]);
    let mut found = [[0.0; 3]; 3];
    for (i, row) in found.iter_mut().enumerate() {
        for (j, x) in row.iter_mut().enumerate() {
            *x = size * (0..3).map(|k| rows[i.min(j)][k] * moments[k] * rows[i.max(j)][k]).sum::<f64>();
        }
    }
    if next() > 0.8 {
        found[1][0] += 0.1 * size;
    }
    found
}

fn of<T: Scalar>(mass: T, about_centre: [[T; 3]; 3]) -> Inertia<T> {
    Inertia { mass, centre: [T::zero(); 3], about_centre }
}

fn value(fault: &Fault) -> f64 {
    match fault {
        Fault::Negative { value, .. } => *value,
        Fault::ImpossibleInertia { excess } => *excess,
        _ => 0.0,
    }
}

/// Both are faults of one kind and value, or none: lanes have the bits of plain numbers.
fn beside(together: Option<Fault>, alone: &[Option<Fault>]) {
    let kind = |fault: &Fault| core::mem::discriminant(fault);
    match together {
        None => assert!(alone.iter().all(Option::is_none), "{alone:?} pass together"),
        Some(found) => {
            let same = |one: &Fault| kind(one) == kind(&found) && value(one) == value(&found);
            assert!(alone.iter().flatten().any(same), "{found:?} of {alone:?}");
        }
    }
}

#[test]
fn tensors_are_checked_lane_by_lane() {
    let mut next = numbers(17);
    let (mut refused, mut doubted) = (0, 0);
    for _ in 0..2000 {
        let each: [Tensor; 4] = core::array::from_fn(|_| tensor(&mut next));
        let lanes = |of: &dyn Fn(usize) -> f64| WideF64x4::from([of(0), of(1), of(2), of(3)]);
        let tensors = core::array::from_fn(|i| core::array::from_fn(|j| lanes(&|lane| each[lane][i][j])));
        let (together, alone) = (of(WideF64x4::literal(1.0), tensors), each.map(|tensor| of(1.0, tensor)));
        let check = together.check();
        refused += u32::from(check.is_err());
        beside(check.err(), &alone.map(|one| one.check().err()));
        if alone.iter().all(|one| one.check().is_ok()) {
            doubted += u32::from(together.doubt().is_some());
            beside(together.doubt(), &alone.map(|one| one.doubt()));
        }
    }
    println!("{refused} of 2000 refused, {doubted} of the others doubted");
    assert!((500..1900).contains(&refused) && doubted > 20);
}

#[test]
fn a_small_lane_is_refused_beside_large_ones() {
    let lanes = |small: f64, large: f64| WideF64x4::from([large, large, small, large]);
    let diagonal = |x, y, z| {
        let o = WideF64x4::literal(0.0);
        [[x, o, o], [o, y, o], [o, o, z]]
    };
    // Its moment of −1e-3 kg·m² is less than the rounding of its neighbours'.
    let tensor = diagonal(lanes(-1e-3, 1e15), lanes(0.02, 1e15), lanes(0.03, 1e15));
    let refused = of(WideF64x4::literal(1.0), tensor).check();
    let Err(Fault::Negative { parameter: "principal moment of inertia", value }) = refused else {
        panic!("{refused:?}")
    };
    assert!((value + 1e-3).abs() < 1e-17, "{value}");
    // A lane without mass that resists turning.
    let tensor = diagonal(lanes(1.0, 1.0), lanes(1.0, 1.0), lanes(1.0, 1.0));
    let idle = Some(Fault::NotPositive { parameter: "mass", value: 0.0 });
    assert_eq!(of(lanes(0.0, 2.0), tensor).doubt(), idle);
    let plate = |mass, about_centre| planar::Inertia { mass, centre: [WideF64x4::literal(0.0); 2], about_centre };
    assert_eq!(plate(lanes(0.0, 2.0), lanes(1.0, 0.0)).doubt(), idle);
    assert_eq!(plate(lanes(0.0, 2.0), lanes(0.0, 3.0)).doubt(), None);
    // In the plane, too, rounding is of the lane's own size.
    let plate = planar::Inertia {
        centre: [lanes(1.0, 1e9), WideF64x4::literal(0.0)],
        ..plate(lanes(1.0, 1.0), lanes(-1e-3, 1.0))
    };
    assert_eq!(plate.check(), Err(Fault::Negative { parameter: "moment of inertia", value: -1e-3 }));
    // And of what masks leave out.
    let link = |small: f64| {
        let (o, i) = (WideF64x4::literal(0.0), lanes(1.0, 1e15));
        robot::Link::<_, 0b100, 0b111>::new(i, [lanes(small, 0.0), o, i], [[i, o, o], [o, i, o], [o, o, i]])
    };
    let built = |small| {
        let chain = (robot::Hinge::level().grounded(), link(small));
        robot::System::new(robot::Base::origin(), chain, robot::Free).map(|_| ()).map_err(|error| error.fault)
    };
    assert_eq!(built(0.0), Ok(()));
    assert!(matches!(built(1e-3), Err(Fault::NotZero { .. })));
}

#[test]
fn a_thin_lane_spins_about_its_line_beside_thick_ones() {
    let number = WideF32x8::literal;
    let mut axial = [0.1_f32; 8];
    let built = |axial: [f32; 8]| {
        let o = number(0.0);
        let tensor = [[axial.into(), o, o], [o, number(0.1), o], [o, o, number(0.1)]];
        let body = RigidBody::new(number(1.0), tensor, [number(0.5), o, o], [number(1.0), o, o]);
        let scene = spatial::System::new(spatial::Pinned::origin(), (body, spatial::Ball, body), spatial::Free);
        let turned = [0.4, 0.5, -0.7, 0.3, -0.2, 0.9].map(number); // where rounding resists the spin
        scene.and_then(|scene| scene.with_accelerations(scene.at_rest(&turned)?, &spatial::Unloaded).map(|_| ()))
    };
    assert_eq!(built(axial), Ok(()));
    axial[3] = 0.0;
    assert_eq!(built(axial).map_err(|error| error.fault), Err(Fault::SingularJoint));
}
