//! Pages and films: what is written where, what is refused. What the pages show is tested in a browser, by
//! tests/python/test_view.py.

use std::fs;
use std::path::Path;

use crate::command::{command, done, example, funnel, said};

/// The head of a page.
fn head(page: &Path) -> serde_json::Value {
    let text = fs::read_to_string(page).unwrap();
    assert!(text.trim_end().ends_with("</html>"));
    let (_, rest) = text.split_once("id=\"head\">").unwrap();
    let (head, _) = rest.split_once("</script>").unwrap();
    serde_json::from_str(head).unwrap()
}

#[test]
fn a_run_ends_with_its_page_and_replaces_it() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    funnel(folder, &[]);
    let run = ["run", "funnel.toml", "-o", "out", "--stop", "0.3"];
    let told = done(folder, &[&run[..], &["--view"]].concat());
    assert!(
        told.out.contains("out/view.html: 200 spheres, 4 frames"),
        "{}",
        told.out
    );
    let page = folder.join("out/view.html");
    let made = head(&page);
    assert_eq!(made["times"].as_array().unwrap().len(), 4);
    assert_eq!(made["boundaries"][0]["name"], "funnel");
    assert_eq!(made["tables"][0]["rows"], 31);

    let again = said(folder, &["view", "out"]);
    assert_eq!(again.code, Some(2));
    assert!(again.error.contains("--overwrite"), "{}", again.error);
    let text = fs::read(&page).unwrap();
    done(folder, &["view", "out", "--overwrite"]);
    assert_eq!(
        fs::read(&page).unwrap(),
        text,
        "the same results give the same page"
    );

    // The page of a run that is replaced goes with it.
    done(folder, &[&run[..], &["--overwrite"]].concat());
    assert!(!page.exists());
}

#[test]
fn a_page_asks_for_nothing_from_outside() {
    let folder = tempfile::tempdir().unwrap();
    let title = "<script src=\"https://example.com/x.js\"></script><!-- ";
    let change = format!("title = '''{title}'''");
    let text = fs::read_to_string(example("funnel")).unwrap();
    let line = text.lines().find(|line| line.starts_with("title")).unwrap();
    funnel(folder.path(), &[(line, &change)]);
    done(folder.path(), &["view", "funnel.toml"]);
    let page = folder.path().join("funnel.html");
    assert_eq!(head(&page)["title"], title, "a title is text");
    let text = fs::read_to_string(&page).unwrap();
    let (data, _) = text.split_once("id=\"licences\"").unwrap();
    assert!(text.contains("default-src 'none'"));
    for tag in ["<script src", "<link", "<img", "@import", "<!--"] {
        assert!(!data.contains(tag), "{tag}");
    }
}

#[test]
fn all_problems_of_a_scene_are_told_and_no_page_is_left() {
    let folder = tempfile::tempdir().unwrap();
    funnel(
        folder.path(),
        &[("duration =", "duratoin ="), ("density =", "denisty =")],
    );
    let told = said(folder.path(), &["view", "funnel.toml"]);
    assert_eq!(told.code, Some(2));
    for word in ["duratoin", "denisty"] {
        assert!(told.error.contains(word), "{}", told.error);
    }
    assert!(!folder.path().join("funnel.html").exists());
}

#[test]
fn folders_without_results_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    funnel(folder, &[]);
    done(
        folder,
        &["run", "funnel.toml", "-o", "a/b", "--stop", "0.05"],
    );
    let above = said(folder, &["view", "a"]);
    assert!(above.error.contains("`a/b` is one"), "{}", above.error);
    // A run without frames.
    fs::write(folder.join("a/b/spheres.pvd"), "").unwrap();
    let damaged = said(folder, &["view", "a/b"]);
    assert!(damaged.error.contains("spheres.pvd"), "{}", damaged.error);
    for name in ["spheres.pvd", "contacts.pvd", "boundaries.pvd"] {
        fs::remove_file(folder.join("a/b").join(name)).unwrap();
    }
    let none = said(folder, &["view", "a/b"]);
    assert!(none.error.contains("vtu_interval"), "{}", none.error);
    assert_eq!(none.code, Some(2));
    // A frame that was cut short.
    done(folder, &["run", "funnel.toml", "-o", "c", "--stop", "0.05"]);
    let frame = folder.join("c/spheres_000000.vtu");
    let bytes = fs::read(&frame).unwrap();
    fs::write(&frame, &bytes[..bytes.len() / 2]).unwrap();
    let short = said(folder, &["view", "c"]);
    assert!(
        short.error.contains("spheres_000000.vtu"),
        "{}",
        short.error
    );
    assert!(short.error.contains("cut short"), "{}", short.error);
}

#[test]
fn an_fmu_that_writes_no_frames_makes_no_page() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    funnel(folder, &[("vtu_interval = 0.1", "vtu_interval = 0")]);
    done(folder, &["export", "funnel.toml"]);
    let told = said(
        folder,
        &[
            "simulate",
            "funnel.fmu",
            "--stop",
            "0.02",
            "-o",
            "o.csv",
            "--view",
            "p.html",
        ],
    );
    assert!(!folder.join("p.html").exists());
    assert_ne!(told.code, Some(0));
    assert!(told.error.contains("vtu_interval"), "{}", told.error);
}

/// `--open` starts the browser, here one that writes down what it was asked for.
#[cfg(target_os = "linux")]
#[test]
fn the_page_is_opened_in_the_browser() {
    use std::os::unix::fs::PermissionsExt;

    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    funnel(folder, &[]);
    let script = folder.join("xdg-open");
    fs::write(
        &script,
        format!("#!/bin/sh\necho \"$1\" > {}/asked\n", folder.display()),
    )
    .unwrap();
    fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).unwrap();
    let path = format!("{}:/usr/bin:/bin", folder.display());
    let mut open = command(folder, &["view", "funnel.toml", "--open"]);
    assert!(open.env("PATH", path).status().unwrap().success());
    let asked = folder.join("asked");
    for _ in 0..100 {
        if asked.exists() && !fs::read_to_string(&asked).unwrap().is_empty() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    let asked = fs::read_to_string(asked).unwrap();
    assert!(asked.trim().ends_with("/funnel.html"), "{asked}");
}

#[test]
fn a_film_without_browser_or_encoder_says_what_to_install() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    funnel(folder, &[]);
    for (name, part) in [("film.mp4", "ffmpeg"), ("scene.png", "chromium")] {
        let mut movie = command(folder, &["movie", "funnel.toml", "-o", name]);
        let movie = movie.env("PATH", folder).env_remove("SPHERE_DDA_BROWSER");
        let told = movie.output().unwrap();
        let error = String::from_utf8(told.stderr).unwrap();
        assert_eq!(told.status.code(), Some(2), "{error}");
        assert!(
            error.contains(&format!("apt-get install {part}")),
            "{error}"
        );
        assert!(!folder.join(name).exists());
    }
}
