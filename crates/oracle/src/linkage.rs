//! A four-bar linkage in closed form.

/// Angles (rad) and rates (rad/s) of coupler and rocker (from its far end towards the ground) for those of the crank, by circles about
/// both ends: of a linkage of crank, coupler, rocker, whose ground pins are as far apart (m) as the last number says.
pub fn four_bar([a, b, c, d]: [f64; 4], [crank, rate]: [f64; 2]) -> [[f64; 2]; 2] {
    let (x, y) = (a * crank.cos(), a * crank.sin());
    let (dx, dy) = (d - x, -y);
    let far = dx.hypot(dy);
    let along = (far * far + b * b - c * c) / (2.0 * far);
    let up = (b * b - along * along).sqrt();
    let (px, py) = (x + (along * dx - up * dy) / far, y + (along * dy + up * dx) / far);
    let (coupler, rocker) = ((py - y).atan2(px - x), (-py).atan2(d - px));
    // a ω n_a + b ω_b n_b + c ω_c n_c = 0.
    let over = b * (rocker - coupler).sin();
    let of_coupler = -a * rate * (rocker - crank).sin() / over;
    let of_rocker = a * rate * (coupler - crank).sin() / (c * (rocker - coupler).sin());
    [[coupler, rocker], [of_coupler, of_rocker]]
}
