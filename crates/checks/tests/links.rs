//! Links lead somewhere: those of texts in the repository, and, where `DOCS` names a folder of rustdoc's, those of its pages.

use std::collections::{HashMap, HashSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// All files below a folder with these endings, but for what is built.
fn files(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            if !name.starts_with('.') && name != "target" && name != "src" {
                files(&path, endings, found)?;
            }
        } else if endings.iter().any(|ending| name.ends_with(ending)) {
            found.push(path);
        }
    }
    Ok(())
}

/// What stands between an opening and a closing sign, wherever.
fn between<'t>(text: &'t str, open: &str, close: char) -> Vec<&'t str> {
    text.split(open).skip(1).filter_map(|rest| rest.split(close).next()).collect()
}

/// The anchors of a text: ids of HTML, headings of Markdown as code hosts make them.
fn anchors(text: &str, markdown: bool) -> HashSet<String> {
    let mut found: HashSet<String> = between(text, "id=\"", '"').into_iter().map(str::to_owned).collect();
    if markdown {
        for heading in text.lines().filter(|line| line.starts_with('#')) {
            let plain = heading.trim_start_matches('#').trim().to_lowercase();
            let kept = plain.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
            found.insert(kept.map(|c| if c == ' ' { '-' } else { c }).collect());
        }
    }
    found
}

/// Markdown without its code.
fn prose(text: &str) -> String {
    let blocks = text.split("```").step_by(2).collect::<String>();
    blocks.split('`').enumerate().map(|(k, part)| if k % 2 == 0 { part } else { "" }).collect()
}

/// Links of these files that lead nowhere.
fn broken(paths: &[PathBuf]) -> Result<(usize, Vec<String>), Box<dyn Error>> {
    let (mut met, mut lost, mut known) = (0, vec![], HashMap::new());
    for path in paths {
        let markdown = path.extension().is_some_and(|ending| ending == "md");
        let text = fs::read_to_string(path)?;
        let text = if markdown { prose(&text) } else { text };
        let links = match markdown {
            true => between(&text, "](", ')'),
            false => [between(&text, "href=\"", '"'), between(&text, "src=\"", '"')].concat(),
        };
        for link in links {
            if link.contains("://")
                || link.starts_with("data:")
                || link.starts_with("mailto:")
                || link.starts_with("javascript:")
            {
                continue;
            }
            met += 1;
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let file = file.split('?').next().unwrap_or_default();
            let to = if file.is_empty() { path.clone() } else { path.parent().unwrap_or(path).join(file) };
            let to = if to.is_dir() && !markdown { to.join("index.html") } else { to };
            if !to.exists() {
                lost.push(format!("{}: {link}", path.display()));
            } else if !anchor.is_empty() && to.is_file() && !anchor.contains('-') | markdown {
                // Lines of sources, `#10-20`, are no anchors.
                let of_markdown = to.extension().is_some_and(|ending| ending == "md");
                let all = match known.get(&to) {
                    Some(all) => all,
                    None => known.entry(to.clone()).or_insert(anchors(&fs::read_to_string(&to)?, of_markdown)),
                };
                if !all.contains(anchor) && anchor.parse::<usize>().is_err() {
                    lost.push(format!("{}: {link}", path.display()));
                }
            }
        }
    }
    Ok((met, lost))
}

#[test]
fn links_lead_somewhere() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut paths = vec![];
    files(&root, &[".md", ".html"], &mut paths)?;
    if let Some(docs) = std::env::var_os("DOCS") {
        files(Path::new(&docs), &[".html"], &mut paths)?;
    }
    let (met, lost) = broken(&paths)?;
    println!("{met} links of {} files", paths.len());
    assert!(met > 50 && lost.is_empty(), "{}", lost.join("\n"));
    Ok(())
}

#[test]
fn a_link_that_leads_nowhere_is_seen() -> Result<(), Box<dyn Error>> {
    let folder = std::env::temp_dir().join(format!("links-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let page = folder.join("page.md");
    fs::write(&page, "# A head\n[here](#a-head) [gone](#no-head) [lost](lost.md) `[code](x)`\n")?;
    let (met, lost) = broken(&[page])?;
    fs::remove_dir_all(&folder)?;
    assert_eq!((met, lost.len()), (3, 2), "{lost:?}");
    Ok(())
}
