//! `run` killed at any moment: what is left can be read, and the run that is resumed leaves the files of one that was
//! never killed.
//!
//! The moments are not drawn: a library put before the system's counts the calls that change files, and kills the
//! process before the call with a given number. Every number gets its turn.

#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{command, done, frames, rows};

/// Counts calls and kills before call number `SPHERE_DDA_TEST_KILL`.
const KILLER: &str = r#"
#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <sys/types.h>
#include <unistd.h>

static void count(void) {
    static long calls, last = -1;
    if (last < 0) last = atol(getenv("SPHERE_DDA_TEST_KILL"));
    if (__atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST) == last) kill(getpid(), SIGKILL);
}
#define NEXT(name, ...) count(); return ((__typeof__(name) *)dlsym(RTLD_NEXT, #name))(__VA_ARGS__)
int rename(const char *a, const char *b) { NEXT(rename, a, b); }
int unlink(const char *a) { NEXT(unlink, a); }
int ftruncate64(int f, off64_t n) { NEXT(ftruncate64, f, n); }
int fsync(int f) { NEXT(fsync, f); }
int fdatasync(int f) { NEXT(fdatasync, f); }
int mkdir(const char *a, mode_t m) { NEXT(mkdir, a, m); }
ssize_t write(int f, const void *p, size_t n) { if (f > 2) count();
    return ((__typeof__(write) *)dlsym(RTLD_NEXT, "write"))(f, p, n); }
int open64(const char *a, int flags, ...) {
    va_list rest; va_start(rest, flags); mode_t m = va_arg(rest, mode_t); va_end(rest);
    NEXT(open64, a, flags, m); }
"#;

/// Three spheres that fall on a floor and touch it; frames, rows and checkpoints at different times, the last step short.
const SCENE: &str = r#"
[simulation]
duration = 0.085
step = 0.01
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }

[[material]]
name = "glass"
density = 2500.0

[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]

[[spheres]]
name = "balls"
material = "glass"
radius = 0.01
lattice = { origin = [0, 0, 0.015], count = [3, 1, 1], spacing = 0.03 }

[output]
vtu_interval = 0.03
checkpoint_interval = 0.02
"#;

struct Bench {
    folder: tempfile::TempDir,
    whole: BTreeMap<String, Vec<u8>>,
}

impl Bench {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        fs::write(path.join("scene.toml"), SCENE).unwrap();
        fs::write(path.join("killer.c"), KILLER).unwrap();
        let mut compile = Command::new("cc");
        compile.args(["-shared", "-fPIC", "killer.c", "-o", "killer.so", "-ldl"]);
        assert!(compile.current_dir(path).status().unwrap().success());
        done(path, &["run", "scene.toml", "-o", "whole"]);
        let whole = files(&path.join("whole"));
        Self { folder, whole }
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    /// Runs or resumes until the given call; whether it was killed there.
    fn run(&self, more: &[&str], call: usize) -> bool {
        let arguments = [&["run", "scene.toml", "-o", "out"], more].concat();
        let told = command(self.folder.path(), &arguments)
            .env("LD_PRELOAD", self.folder.path().join("killer.so"))
            .env("SPHERE_DDA_TEST_KILL", call.to_string())
            .output()
            .unwrap();
        let killed = told.status.signal() == Some(9);
        assert!(
            told.status.success() || killed,
            "{more:?} killed before call {call}: {}",
            String::from_utf8_lossy(&told.stderr)
        );
        self.check(call);
        killed
    }

    /// Everything that is listed is whole.
    fn check(&self, call: usize) {
        for series in ["spheres", "contacts", "boundaries"] {
            let pvd = self.out().join(format!("{series}.pvd"));
            if pvd.exists() {
                assert!(frames(&pvd) > 0, "call {call}");
            }
        }
        let history = self.out().join("history.csv");
        if history.exists() && fs::metadata(&history).unwrap().len() > 0 {
            rows(&history);
        }
    }

    /// What stands now is the run that was never killed, bit for bit.
    fn expect_whole(&self, what: &str) {
        let found = files(&self.out());
        let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
        assert_eq!(names(&found), names(&self.whole), "{what}");
        for (name, bytes) in &self.whole {
            assert!(found[name] == *bytes, "{what}: {name} differs");
        }
    }
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        (name, fs::read(entry.path()).unwrap())
    });
    entries.collect()
}

/// Never reached.
const LATE: usize = 1_000_000;

#[test]
fn killed_before_any_call_a_run_is_resumed_to_the_same_files() {
    let bench = Bench::new();
    let mut call = 1;
    while bench.run(&[], call) {
        bench.run(&["--resume"], LATE);
        bench.expect_whole(&format!("killed before call {call}"));
        fs::remove_dir_all(bench.out()).unwrap();
        call += 1;
    }
    assert!(call > 150, "{call} calls: the library was not asked");
    bench.expect_whole("not killed");
    // A finished run is left as it is.
    bench.run(&["--resume"], LATE);
    bench.expect_whole("resumed when finished");
}

#[test]
fn killed_before_any_call_while_resuming_a_run_is_resumed_all_the_same() {
    let bench = Bench::new();
    // Late enough for frames and rows behind the last checkpoint.
    for first in [90, 151] {
        let mut call = 1;
        loop {
            assert!(bench.run(&[], first));
            if !bench.run(&["--resume"], call) {
                break;
            }
            bench.run(&["--resume"], LATE);
            bench.expect_whole(&format!("killed before calls {first} and {call}"));
            fs::remove_dir_all(bench.out()).unwrap();
            // Its beginning is where it differs from a run that was not resumed.
            call += if call < 40 { 1 } else { 17 };
        }
        fs::remove_dir_all(bench.out()).unwrap();
    }
}

#[test]
fn killed_before_any_call_while_replacing_another_run_nothing_of_it_survives() {
    let bench = Bench::new();
    let scene = bench.folder.path().join("scene.toml");
    let other = SCENE.replace("spacing = 0.03", "spacing = 0.04");
    for call in 1..60 {
        fs::write(&scene, &other).unwrap();
        bench.run(&[], LATE);
        fs::write(&scene, SCENE).unwrap();
        assert!(bench.run(&["--overwrite"], call));
        // Until the directory says whose it is, it must be replaced again; then the new run can be resumed.
        let about = fs::read_to_string(bench.out().join("run.json")).unwrap();
        let own = String::from_utf8_lossy(&bench.whole["run.json"]) == about;
        bench.run(&[if own { "--resume" } else { "--overwrite" }], LATE);
        bench.expect_whole(&format!("killed before call {call}"));
        fs::remove_dir_all(bench.out()).unwrap();
    }
}
