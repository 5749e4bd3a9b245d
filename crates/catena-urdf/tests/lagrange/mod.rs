//! Lagrange's equations of a description, from its text: every link by itself, in the axes that the text gives it, nothing lumped,
//! nothing snapped, no recursion of forces. Fixed base only.

use std::collections::HashMap;

type Vector = [f64; 3];
type Matrix = [[f64; 3]; 3];

/// A link with the joint that carries it.
struct Link {
    parent: Option<usize>,
    place: Vector,
    turn: Matrix,
    /// Number of the coordinate, whether it slides, and its axis.
    joint: Option<(usize, bool, Vector)>,
    mass: f64,
    centre: Vector,
    tensor: Matrix,
}

pub struct Lagrange {
    links: Vec<Link>,
    pub joints: usize,
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|k| (0..3).map(|j| a[i][j] * b[j][k]).sum()))
}
fn apply(a: &Matrix, x: Vector) -> Vector {
    std::array::from_fn(|i| (0..3).map(|k| a[i][k] * x[k]).sum())
}
fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
fn sum(a: Vector, b: Vector, factor: f64) -> Vector {
    std::array::from_fn(|i| a[i] + factor * b[i])
}
fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// Rodrigues by half angles, as a quaternion's matrix.
fn about(axis: Vector, angle: f64) -> Matrix {
    let length = dot(axis, axis).sqrt();
    let (s, w) = (0.5 * angle).sin_cos();
    let [x, y, z] = axis.map(|a| s * a / length);
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

fn numbers(node: Option<roxmltree::Node>, attribute: &str, default: Vector) -> Vector {
    let Some(text) = node.and_then(|node| node.attribute(attribute)) else { return default };
    let list: Vec<f64> = text.split_whitespace().map(|x| x.parse().expect("a number")).collect();
    [list[0], list[1], list[2]]
}

fn child<'a>(node: roxmltree::Node<'a, 'a>, name: &str) -> Option<roxmltree::Node<'a, 'a>> {
    node.children().find(|child| child.has_tag_name(name))
}

fn turn(rpy: Vector) -> Matrix {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    product(&about(z, rpy[2]), &product(&about(y, rpy[1]), &about(x, rpy[0])))
}

impl Lagrange {
    /// Of a text whose joints stand in the order in which a walk from the root meets them.
    pub fn of(text: &str) -> Self {
        let document = roxmltree::Document::parse(text).expect("XML");
        let root = document.root_element();
        let mut links = vec![];
        let mut numbers_of = HashMap::new();
        let nodes: HashMap<_, _> = root
            .children()
            .filter(|node| node.has_tag_name("link"))
            .map(|node| (node.attribute("name").expect("name"), node))
            .collect();
        let joints: Vec<_> = root.children().filter(|node| node.has_tag_name("joint")).collect();
        let end = |joint: &roxmltree::Node, role| {
            joint
                .children()
                .find(|node| node.has_tag_name(role))
                .and_then(|node| node.attribute("link"))
                .expect("link")
                .to_owned()
        };
        let children: Vec<_> = joints.iter().map(|joint| end(joint, "child")).collect();
        let top = nodes.keys().find(|name| !children.contains(&(**name).to_owned())).expect("root").to_string();
        let mut moving = 0;
        let mut add = |name: &str, parent, pose: (Vector, Matrix), joint, links: &mut Vec<Link>| {
            let inertial = child(nodes[name], "inertial");
            let origin = inertial.and_then(|inertial| child(inertial, "origin"));
            let number = |element: &str, attribute: &str| -> f64 {
                let node = inertial.and_then(|inertial| child(inertial, element));
                node.and_then(|node| node.attribute(attribute)).map_or(0.0, |text| text.parse().expect("a number"))
            };
            let i = |attribute| number("inertia", attribute);
            let tensor =
                [[i("ixx"), i("ixy"), i("ixz")], [i("ixy"), i("iyy"), i("iyz")], [i("ixz"), i("iyz"), i("izz")]];
            let axes = turn(numbers(origin, "rpy", [0.0; 3]));
            let back: Matrix = std::array::from_fn(|i| std::array::from_fn(|k| axes[k][i]));
            let tensor = product(&axes, &product(&tensor, &back));
            let centre = numbers(origin, "xyz", [0.0; 3]);
            links.push(Link {
                parent,
                place: pose.0,
                turn: pose.1,
                joint,
                mass: number("mass", "value"),
                centre,
                tensor,
            });
            numbers_of.insert(name.to_owned(), links.len() - 1);
            links.len() - 1
        };
        add(&top, None, ([0.0; 3], turn([0.0; 3])), None, &mut links);
        // Depth first, as joints stand in the text.
        let mut stack = vec![(top, 0)];
        let mut visit = vec![];
        while let Some((name, number)) = stack.pop() {
            visit.push((name.clone(), number));
            let own: Vec<_> = joints.iter().filter(|joint| end(joint, "parent") == name).collect();
            for joint in own.into_iter().rev() {
                stack.push((end(joint, "child"), 1 + joint.id().get_usize()));
            }
        }
        let mut places: HashMap<String, usize> = HashMap::new();
        for (name, joint) in visit {
            if joint == 0 {
                places.insert(name, 0);
                continue;
            }
            let joint = joints.iter().find(|node| 1 + node.id().get_usize() == joint).expect("joint");
            let origin = child(*joint, "origin");
            let pose = (numbers(origin, "xyz", [0.0; 3]), turn(numbers(origin, "rpy", [0.0; 3])));
            let axis = numbers(child(*joint, "axis"), "xyz", [1.0, 0.0, 0.0]);
            let axis = axis.map(|x| x / dot(axis, axis).sqrt());
            let parent = Some(places[&end(joint, "parent")]);
            let own = match joint.attribute("type") {
                Some("fixed") => None,
                kind => {
                    moving += 1;
                    Some((moving - 1, kind == Some("prismatic"), axis))
                }
            };
            let number = add(&name, parent, pose, own, &mut links);
            places.insert(name, number);
        }
        Self { links, joints: moving }
    }

    /// Mass matrix and potential energy, by Jacobians of every link's mass centre and axes.
    fn energies(&self, q: &[f64], gravity: Vector) -> (Vec<Vec<f64>>, f64) {
        let mut frames: Vec<(Vector, Matrix)> = vec![];
        let mut axes = vec![([0.0; 3], [0.0; 3], false); self.joints];
        let mut chains: Vec<Vec<usize>> = vec![];
        let (mut mass, mut potential) = (vec![vec![0.0; self.joints]; self.joints], 0.0);
        for link in &self.links {
            let (mut place, mut axes_of, mut chain) = match link.parent {
                None => (link.place, link.turn, vec![]),
                Some(parent) => {
                    let (place, outer) = &frames[parent];
                    (sum(*place, apply(outer, link.place), 1.0), product(outer, &link.turn), chains[parent].clone())
                }
            };
            if let Some((number, slides, axis)) = link.joint {
                let direction = apply(&axes_of, axis);
                if slides {
                    place = sum(place, direction, q[number]);
                } else {
                    axes_of = product(&axes_of, &about(axis, q[number]));
                }
                axes[number] = (place, direction, slides);
                chain.push(number);
            }
            let centre = sum(place, apply(&axes_of, link.centre), 1.0);
            potential -= link.mass * dot(gravity, centre);
            let back: Matrix = std::array::from_fn(|i| std::array::from_fn(|k| axes_of[k][i]));
            let tensor = product(&axes_of, &product(&link.tensor, &back));
            let columns: Vec<_> = chain
                .iter()
                .map(|number| match axes[*number] {
                    (_, direction, true) => (*number, direction, [0.0; 3]),
                    (from, direction, false) => (*number, cross(direction, sum(centre, from, -1.0)), direction),
                })
                .collect();
            for (i, linear, angular) in &columns {
                for (k, other, spin) in &columns {
                    mass[*i][*k] += link.mass * dot(*linear, *other) + dot(*angular, apply(&tensor, *spin));
                }
            }
            frames.push((place, axes_of));
            chains.push(chain);
        }
        (mass, potential)
    }

    pub fn mass_matrix(&self, q: &[f64]) -> Vec<Vec<f64>> {
        self.energies(q, [0.0; 3]).0
    }

    /// τ = M a + Ṁ v − ∂(½ vᵀ M v)/∂q + ∂V/∂q, derivatives as differences of sixth order.
    pub fn torques(&self, q: &[f64], v: &[f64], a: &[f64], gravity: Vector) -> Vec<f64> {
        const STEP: f64 = 0.02;
        const WEIGHTS: [(f64, f64); 3] = [(1.0, 0.75), (2.0, -0.15), (3.0, 1.0 / 60.0)];
        let n = self.joints;
        let mass = self.mass_matrix(q);
        let mut torques: Vec<f64> = (0..n).map(|i| (0..n).map(|k| mass[i][k] * a[k]).sum()).collect();
        for j in 0..n {
            for (steps, weight) in WEIGHTS {
                for side in [1.0, -1.0] {
                    let mut moved = q.to_vec();
                    moved[j] += side * steps * STEP;
                    let (mass, potential) = self.energies(&moved, gravity);
                    let factor = side * weight / STEP;
                    torques[j] += factor * potential;
                    for i in 0..n {
                        for k in 0..n {
                            torques[i] += factor * v[j] * mass[i][k] * v[k];
                            torques[j] -= factor * 0.5 * v[i] * mass[i][k] * v[k];
                        }
                    }
                }
            }
        }
        torques
    }
}
