//! A file imports from its own floor or from lower ones: mechanics knows nothing of steps, rules know nothing of
//! mechanics.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// Modules from the ground up. What they are is said in docs/DESIGN.md.
const FLOORS: [&[&str]; 9] = [
    &["scalar", "sealed", "data", "error", "names", "state", "tuples"],
    &["mirror", "relation", "time", "lift", "dense"],
    &[
        "space",
        "loading",
        "sweep",
        "spring",
        "shape",
        "walks",
        "visit",
        "element",
        "ends",
        "transfer",
        "turning",
        "motion",
        "sensitive",
        "series",
        "adjoint",
        "release",
        "inner",
        "kinematics",
        "struts",
    ],
    &["chain", "guarded", "counts", "driven"],
    &["mechanics"],
    &["solve", "observe"],
    &["system"],
    &["stepper", "simulate", "observers", "modes", "couplings", "sensitivity", "paper", "extend", "internals"],
    &["planar", "spatial", "robot", "guide"],
];

fn floor(module: &str) -> Option<usize> {
    FLOORS.iter().position(|modules| modules.contains(&module))
}

/// Names that the crate's root gives to things of its modules.
fn home(name: &str) -> &str {
    match name {
        "Lift" => "lift",
        "Cause" | "Error" | "Fault" | "Place" => "error",
        "Motion" => "motion",
        "compound" | "joint" => "extend", // macros
        "differentiable" => "sensitivity",
        "BodyNumbers" | "JointNumbers" | "Label" | "Which" => "names",
        "Real" | "Scalar" => "scalar",
        "StateVector" | "TransferMatrix" => "state",
        module => module,
    }
}

/// All `.rs` files below a folder.
pub(super) fn sources(folder: &Path, found: &mut Vec<PathBuf>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            sources(&path, found)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    Ok(())
}

/// Code without comments (and the examples in them) and unit tests.
fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    code.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The first names of all paths in the crate, `crate::name` or `crate::{name, name::{..}}`.
fn imports(code: &str) -> Vec<String> {
    let name =
        |text: &str| text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let mut found = vec![];
    for rest in code.split("crate::").skip(1) {
        let Some(group) = rest.strip_prefix('{') else {
            found.push(name(rest));
            continue;
        };
        let (mut depth, mut start) = (1, 0);
        for (i, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => (),
            }
            if (c == ',' && depth == 1) || depth == 0 {
                found.push(name(&group[start..i]));
                start = i + 1;
            }
            if depth == 0 {
                break;
            }
        }
    }
    found.retain(|name| !name.is_empty());
    found
}

#[test]
fn every_form_of_import_is_seen() {
    let code = code(
        "//! See crate::simulate.\nuse crate::error::Error;\npub use crate::{scalar::{Real, Scalar}, Motion};\n\
         let x: crate::element::RealOf<S>; // crate::system\n\
         use crate::{\n    ends::Tip,\n};\n#[cfg(test)]\nmod tests {\n    use crate::stepper::Stepper;\n}\n",
    );
    assert_eq!(imports(&code), ["error", "scalar", "Motion", "element", "ends"]);
}

/// The formulation of 2005 lives apart: nothing outside of its folder reads it.
#[test]
fn nothing_knows_of_the_paper_but_itself() -> Result<(), Box<dyn Error>> {
    let (source, mut files) = (Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), vec![]);
    sources(&source, &mut files)?;
    for path in files.iter().filter(|path| !path.starts_with(source.join("paper"))) {
        let code = code(&fs::read_to_string(path)?);
        let names = code.replace("pub mod paper;", "");
        let reads = names.contains("paper::") || names.contains("paper;");
        assert!(!reads, "{} reads paper", path.display());
    }
    Ok(())
}

#[test]
fn files_import_from_no_higher_floor_than_their_own() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = vec![];
    sources(&root, &mut files)?;
    files.sort();
    let (mut wrong, mut seen, mut count) = (vec![], vec![], 0);
    for path in files {
        let file = path.strip_prefix(&root)?.to_string_lossy().replace('\\', "/");
        let module = file.split('/').next().unwrap_or_default().trim_end_matches(".rs").to_owned();
        if module == "lib" {
            continue; // the roof
        }
        let Some(own) = floor(&module) else {
            wrong.push(format!("{file} is on no floor: say where it belongs"));
            continue;
        };
        for name in imports(&code(&fs::read_to_string(&path)?)) {
            let target = home(&name);
            count += 1;
            match floor(target) {
                None => wrong.push(format!("{file} imports {name}, which is on no floor")),
                Some(other) if other > own => {
                    wrong.push(format!("{file} (floor {own}) imports {name} (floor {other})"))
                }
                Some(_) => (),
            }
        }
        seen.push(module);
    }
    for module in FLOORS.iter().flat_map(|modules| modules.iter()) {
        if !seen.iter().any(|seen| seen == module) {
            wrong.push(format!("there is no module {module}"));
        }
    }
    println!("{count} imports in {} files", seen.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 50, "imports are no longer found");
    Ok(())
}
