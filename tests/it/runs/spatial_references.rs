//! Examples 4 and 5 of the paper and the heavy top, against numbers from other codes.

use catena::Error;
use catena::spatial::*;

/// The body of both examples: mass centre and principal axes beside the line between the joints.
fn body() -> RigidBody<f64> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0])
}

fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        catena_oracle::near(*found, *expected, tolerance);
    }
}

/// The quaternion with the sign of another.
fn signed(found: [f64; 4], like: [f64; 4]) -> [f64; 4] {
    let along: f64 = found.iter().zip(like).map(|(a, b)| a * b).sum();
    found.map(|x| x * along.signum())
}

/// Quaternion (body to inertial axes, w first), angular velocity (body axes) and force at the inboard joint (inertial axes): an
/// articulated-body code and a dense system of Newton-Euler equations at tolerance 1e-13, agreeing to 4e-13.
type Row = ([f64; 4], [f64; 3], [f64; 3], [f64; 3]);

const EXAMPLE_4: [(f64, Row); 3] = [
    (
        1.0,
        (
            [0.12813130917, 0.362165823134, -0.101543129485, -0.917664032759],
            [-1.668353584206, 2.168673955934, 0.942117105246],
            [0.371281069924, 0.692770393021, -2.728768005859],
            [3.620248298227, 4.963809523534, 3.596624971111],
        ),
    ),
    (
        2.0,
        (
            [0.593193214937, 0.201298066605, -0.760246864891, -0.172120895179],
            [0.347275471878, -2.201398450071, -1.886358506608],
            [2.013009211062, -0.98387818666, -1.969900316615],
            [1.410152603826, 6.207844239521, -6.467549809871],
        ),
    ),
    (
        5.0,
        (
            [0.133778934394, -0.627061270099, 0.555989551559, -0.528935703853],
            [-2.067863029287, 0.144129854898, 4.402905412164],
            [-2.062289115682, -0.540530354559, -1.779668057924],
            [3.682501659235, 15.619148255739, -7.44027563423],
        ),
    ),
];

#[test]
fn example_4_one_body_on_a_ball() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), body(), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let start = system.with_rates(system.at_rest(&[0.3, 0.2, -0.4])?, &[1.0, -2.0, 0.5])?;
    let start = system.with_accelerations(start, &Unloaded)?;
    near(&start.acceleration().0, &[0.48084217704516696, -4.626867747096629, -10.609616898024486], 1e-13);
    let force = system.stations(&start, &Unloaded)?.root().internal.force;
    near(force.as_slice(), &[-4.142261155190138, 4.164154527632018, 1.0052920493580655], 1e-13);
    let budget = system.budget(&start)?;
    catena_oracle::near(budget.energy(), -0.7861716562812122, 1e-14);
    near(budget.angular_momentum.as_slice(), &[-0.234602333902, -0.677433151884, -0.042932763201], 1e-12);
    for (time, (quaternion, rate, angles, force)) in EXAMPLE_4 {
        let run = system.simulate(start, Dop853::tolerance(1e-13), time, |_| ())?;
        let rotation = run.motion.position().0;
        println!("t = {time}: {:?}, {} sweeps", rotation.quaternion(), run.sweeps);
        near(&signed(rotation.quaternion(), quaternion), &quaternion, 1e-11);
        near(&run.motion.rate().0, &rate, 1e-11);
        near(&rotation.angles(), &angles, 1e-11);
        near(system.stations(&run.motion, &Unloaded)?.root().internal.force.as_slice(), &force, 1e-10);
    }
    Ok(())
}

const EXAMPLE_5: [(f64, [Row; 3]); 3] = [
    (
        0.5,
        [
            (
                [0.853025406475, -0.247584550256, 0.123015499803, -0.442624822158],
                [-3.397951937262, 0.937559548785, -1.507617933341],
                [-0.560151138684, -0.009303575821, -0.954611418474],
                [-17.976201169873, 31.822408151591, 0.065869868085],
            ),
            (
                [0.969501840409, -0.047954149242, 0.024198817557, -0.239125486393],
                [-1.066773625594, 0.437440272338, -4.135016584857],
                [-0.104778085307, 0.023989778783, -0.484900336772],
                [-20.024939202018, 17.929526942316, 0.535348866422],
            ),
            (
                [0.99977920567, 0.012016680386, -0.005819065598, 0.01622583675],
                [0.019996885665, -0.128254469073, -0.644643065904],
                [0.023843198917, -0.012025812812, 0.032312615412],
                [-15.00371827419, 2.891278625157, 0.582233455711],
            ),
        ],
    ),
    (
        1.0,
        [
            (
                [0.049657750312, -0.61509008634, 0.785126065179, -0.052681640981],
                [-5.973223387004, 0.217887970148, 3.004476624708],
                [-2.997268232699, 0.013167658531, -1.811532109802],
                [9.470109594365, 50.942943141779, 0.984682053201],
            ),
            (
                [0.348690979567, -0.24983343804, 0.473475305438, -0.769297724647],
                [1.572069245332, 3.408406459347, -2.386646415324],
                [-1.129140432033, -0.054226025762, -2.256123087488],
                [16.429851789679, 34.71657528167, -0.454991131563],
            ),
            (
                [0.22532618981, 0.045272265908, -0.21040950911, -0.950213854141],
                [1.253968239864, 0.728773901243, -0.333292545497],
                [0.433760853716, -0.008784990424, -2.677865406295],
                [17.622235742079, 13.90676639294, -0.740376209416],
            ),
        ],
    ),
    (
        2.0,
        [
            (
                [0.20248422214, -0.439899028072, 0.814700552902, -0.318985883681],
                [-2.222206323619, -0.75319576707, -1.431878609362],
                [-2.367943556383, 0.04930482903, -2.131313162773],
                [8.444353526855, 19.407475672093, 1.443089721714],
            ),
            (
                [0.067038804211, -0.010773907758, -0.850267126264, -0.521953576131],
                [0.726174562141, 3.055506364886, -2.696800335124],
                [2.03720516031, -0.125578543678, -3.089498166911],
                [10.305119280157, 6.702369411809, -0.408275411505],
            ),
            (
                [0.277495230453, 0.393876177429, 0.766037167375, 0.425493844996],
                [2.335006415019, -2.600173907531, 2.499547523839],
                [2.078157787624, 0.090081322453, 2.138736640448],
                [6.937283602482, -4.139942244478, -0.856349536214],
            ),
        ],
    ),
];

#[test]
fn example_5_three_bodies_on_balls() -> Result<(), Error> {
    let body = body();
    let system = System::new(Pinned::origin(), (body, Ball, body, Ball, body), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let rates = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0];
    let start = system.with_accelerations(system.with_rates(system.motion(), &rates)?, &Unloaded)?;
    let (first, (_, second, _, third, _)) = start.acceleration();
    near(first, &[-2.441179661520804, 0.04513622828947826, -11.964247167796179], 1e-12);
    near(second, &[0.550258025936051, -0.06704004518066103, 2.648331134970065], 1e-12);
    near(third, &[-0.07693473425805511, 0.03643542475082301, -0.7021656720004278], 1e-12);
    let stations = system.stations(&start, &Unloaded)?;
    let forces = [
        [0.2952518189876034, 3.1014388195675817, -0.08933390642339985],
        [-0.06277287148049238, -0.6776140033039102, 0.0064695975669634],
        [0.01533626166499637, 0.14146243648851176, 0.0015780624880296162],
    ];
    for (k, force) in forces.iter().enumerate() {
        let found = stations.get(2 * k).map(|station| station.internal.force).unwrap_or_default();
        near(found.as_slice(), force, 1e-12);
    }
    catena_oracle::near(system.budget(&start)?.energy(), 0.884602, 1e-6);
    for (time, rows) in EXAMPLE_5 {
        let run = system.simulate(start, Dop853::tolerance(1e-13), time, |_| ())?;
        println!("t = {time}: {} sweeps", run.sweeps);
        let stations = system.stations(&run.motion, &Unloaded)?;
        for (k, (body, (quaternion, rate, angles, force))) in
            system.body_motions(&run.motion)?.iter().zip(rows).enumerate()
        {
            near(&signed(body.attitude().quaternion(), quaternion), &quaternion, 1e-11);
            near(&body.rate(), &rate, 1e-11);
            near(&body.attitude().angles(), &angles, 1e-11);
            let found = stations.get(2 * k).map(|station| station.internal.force).unwrap_or_default();
            near(found.as_slice(), &force, 1e-10);
        }
    }
    Ok(())
}

/// Brüls, Cardona and Arnold's top; places of the mass centre by an order 8 method at two tolerances that agree to 1e-11.
#[test]
fn heavy_top() -> Result<(), Error> {
    let tensor = [[0.234375, 0.0, 0.0], [0.0, 0.46875, 0.0], [0.0, 0.0, 0.234375]];
    let top = RigidBody::new(15.0, tensor, [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
    let system = System::new(Pinned::origin(), top, Free)?.with_gravity([0.0, 0.0, -9.81]);
    let start = system.with_rates(system.motion(), &[0.0, 150.0, -4.61538])?;
    let places = [
        (0.1, [0.42129665893, 0.89457197435, -0.14916470056], 1e-10),
        (0.2, [0.60555056138, 0.59895768179, -0.52398302743], 1e-10),
        (0.5, [-0.7024682970, -0.0211651847, -0.7114002577], 2e-10),
        (1.0, [0.1733439641, 0.6400885921, -0.7484907911], 2e-10),
        (2.0, [-0.1504168227, -0.7241655916, -0.6730222696], 4e-10),
    ];
    for (time, place, tolerance) in places {
        let run = system.simulate(start, Dop853::tolerance(1e-13), time, |_| ())?;
        let bodies = system.body_motions(&run.motion)?;
        let found = bodies.get(0).map(|body| body.centre().place).unwrap_or_default();
        println!("t = {time}: {found:?}, {} sweeps", run.sweeps);
        near(found.as_slice(), &place, tolerance);
        if time == 2.0 {
            let quaternion = [0.12294713504, -0.49107989255, 0.35043003034, -0.78798688755];
            near(&signed(run.motion.position().0.quaternion(), quaternion), &quaternion, 1e-9);
        }
    }
    Ok(())
}
