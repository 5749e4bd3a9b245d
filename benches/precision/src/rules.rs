//! All rules on one scene.

/// A reference for a scene by DOP853 and by Adams' rule of variable order, both at their tightest.
#[macro_export]
macro_rules! reference {
    ($name:literal, $end:expr, ($system:expr, $start:expr, $loads:expr), |$own:ident, $motion:ident| $read:expr) => {{
        let (system, start, loads) = (&$system, $start, &$loads);
        macro_rules! by {
            ($rule:expr) => {
                (|| {
                    let run = system.simulation($rule).loads(loads).run(start.clone(), $end, |_| ()).ok()?;
                    let ($own, $motion) = (system, &run.motion);
                    $read
                })()
            };
        }
        use catena::time::{Dop853, Vcabm};
        $crate::agreed($name, [by!(Dop853::tolerance(1e-14)), by!(Vcabm::default().tolerance(1e-13))])
    }};
}

/// Runs all rules in one precision and adds their series to a scene. `$unit` is the coarsest step (s) of RK4, `$read` tells of a system
/// and a motion what the error is of. `taylor` for scenes that Taylor series know.
#[macro_export]
macro_rules! run_rules {
    ($scene:ident, $T:ident, $unit:expr, $finest:expr, ($system:expr, $start:expr, $loads:expr), |$own:ident, $motion:ident| $read:expr $(, $taylor:ident)?) => {{
        let (system, start, loads) = (&$system, $start, &$loads);
        let (tolerances, end) = ($crate::ladder(1e-2, $finest, 0.1), $scene.end() as $T);
        let steps = |share: f64| $crate::ladder($unit * share, $unit * share * 5e-3, 0.5_f64.sqrt());
        macro_rules! add {
            ($name:literal $control:literal, $parameters:expr, $rule:expr) => {{
                $scene.measure(($name, $control, stringify!($T)), &$parameters, |parameter| {
                    let start = std::hint::black_box(start.clone());
                    let rule = $rule;
                    let run = system.simulation(rule(parameter as $T)).loads(loads).run(start, end, |_| ()).ok()?;
                    let ($own, $motion) = (system, &run.motion);
                    Some((run.sweeps, $read?))
                });
            }};
        }
        use catena::time::*;
        add!("RK4" "fixed", steps(1.0), Rk4::step);
        add!("DOPRI5" "fixed", steps(2.0), Dopri5::step);
        add!("DOPRI5" "controlled", tolerances, Dopri5::tolerance);
        add!("DOP853" "fixed", steps(4.0), Dop853::step);
        add!("DOP853" "controlled", tolerances, Dop853::tolerance);
        add!("Adams" "fixed", steps(1.0), Adams::step);
        add!("Adams" "controlled", tolerances, Adams::tolerance);
        add!("Vcabm" "controlled", tolerances, |tolerance| Vcabm::default().tolerance(tolerance));
        add!("Auto" "controlled", tolerances, Auto::tolerance);
        add!("generalised-alpha" "fixed", steps(1.0), |step| GeneralizedAlpha::new(0.8).step(step));
        add!("generalised-alpha" "controlled", tolerances, |tolerance| GeneralizedAlpha::new(0.8).tolerance(tolerance));
        add!("SDIRK4" "fixed", steps(2.0), |step| Sdirk4::new().step(step));
        add!("SDIRK4" "controlled", tolerances, |tolerance| Sdirk4::new().tolerance(tolerance));
        $( $crate::run_rules!(@ $taylor add, tolerances); )?
    }};
    (@ taylor $add:ident, $tolerances:ident) => {
        $add!("Taylor 24" "controlled", $tolerances, Taylor::<24>::tolerance);
        $add!("AutoTaylor 24" "controlled", $tolerances, AutoTaylor::<24>::tolerance);
    };
}
