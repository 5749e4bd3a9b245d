//! A camera: points of space as they are seen in perspective.

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// A camera at a place that looks at another one, z upward. What it sees has its true size there.
pub struct Camera {
    eye: Vector,
    distance: f64,
    axes: [Vector; 3],
}

impl Camera {
    pub fn new(eye: Vector, target: Vector) -> Self {
        let way: Vector = core::array::from_fn(|k| target[k] - eye[k]);
        let forward = unit(way);
        let right = unit(cross(forward, [0.0, 0.0, 1.0]));
        Self { eye, distance: dot(way, way).sqrt(), axes: [right, cross(right, forward), forward] }
    }

    /// Where a point is seen, rightward and upward (m).
    pub fn sees(&self, point: Vector) -> (f64, f64) {
        let way: Vector = core::array::from_fn(|k| point[k] - self.eye[k]);
        let [x, y, depth] = self.axes.map(|axis| dot(axis, way));
        (self.distance * x / depth, self.distance * y / depth)
    }

    /// Lines of a floor at z = 0 between two corners, so far apart (m).
    pub fn floor(&self, [from, to]: [[f64; 2]; 2], apart: f64) -> Vec<Vec<(f64, f64)>> {
        let count = |k: usize| ((to[k] - from[k]) / apart).round() as usize;
        let line = |a: [f64; 2], b: [f64; 2]| [a, b].map(|[x, y]| self.sees([x, y, 0.0])).to_vec();
        let along = (0..=count(1)).map(|i| from[1] + apart * i as f64).map(|y| line([from[0], y], [to[0], y]));
        let across = (0..=count(0)).map(|i| from[0] + apart * i as f64).map(|x| line([x, from[1]], [x, to[1]]));
        along.chain(across).collect()
    }
}
