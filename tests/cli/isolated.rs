//! FMUs in processes of their own (`simulate --isolate`): what they do to their process is a message.
//!
//! Fault: a foreign FMU that crashed, called `exit(0)` or hung took the command with it, with exit code 0 for the second.

#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::command::{command, done, rows, said};
use crate::failing::fails;
use crate::foreign_fmu::{Build, pack, pack_reference_of};

/// An oscillator that does `what` in the call of `function` from `time` \[s\] on; the message has these parts.
fn ends(function: &str, what: &str, time: &str, more: &[&str], parts: &[&str]) -> usize {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    pack(&folder.join("bad.fmu"), Build::Whole, |_| ());
    let fault = format!("fault={function}:{what}");
    let from = format!("faultTime={time}");
    let arguments = [
        "--isolate",
        "-o",
        "out.csv",
        "--set",
        &fault,
        "--set",
        &from,
    ];
    fails(folder, &[&arguments[..], more].concat(), 1, parts);
    match folder.join("out.csv").exists() {
        true => rows(&folder.join("out.csv")),
        false => 0,
    }
}

#[test]
fn a_step_that_does_not_come_back_is_a_message_and_rows_stay() {
    for (what, how) in [
        ("crash", "signal: 11 (SIGSEGV)"),
        ("abort", "signal: 6 (SIGABRT)"),
        ("exit", "exit status: 0"),
    ] {
        let found = format!("bad.fmu: fmi2DoStep: found the process of the FMU ended by {how}");
        let parts = ["at time 0.2 s: ", &found];
        assert_eq!(ends("fmi2DoStep", what, "0.2", &[], &parts), 5, "{what}");
    }
}

#[test]
fn a_step_that_takes_longer_than_allowed_is_a_message_and_rows_stay() {
    let began = Instant::now();
    let parts = ["at time 0.2 s: bad.fmu: fmi2DoStep: found no return within the limit of 0.5 s"];
    let limit = ["--call-timeout", "0.5"];
    assert_eq!(ends("fmi2DoStep", "hang", "0.2", &limit, &parts), 5);
    assert!(began.elapsed() < Duration::from_secs(20));
    // The limit is one for each call, not for all of them.
    let folder = tempfile::tempdir().unwrap();
    pack(&folder.path().join("slow.fmu"), Build::Whole, |_| ());
    let arguments = ["simulate", "slow.fmu", "--isolate", "--call-timeout", "1"];
    let slow = ["--set", "fault=fmi2DoStep:sleep"];
    let began = Instant::now();
    done(folder.path(), &[&arguments[..], &slow].concat());
    assert!(began.elapsed() > Duration::from_secs(2));
    let alone = ["simulate", "slow.fmu", "--call-timeout", "1"];
    let refused = said(folder.path(), &alone);
    assert_eq!(refused.code, Some(2), "{}", refused.error);
}

#[test]
fn the_call_that_does_not_come_back_is_named() {
    for (function, rows) in [
        ("fmi2EnterInitializationMode", 0),
        ("fmi2GetReal", 0),
        ("fmi2Terminate", 41),
        ("fmi2FreeInstance", 41),
    ] {
        let part = format!("bad.fmu: {function}: found the process of the FMU ended by signal: 6");
        let found = ends(function, "abort", "0", &[], &[&part]);
        assert_eq!(found, rows, "{function}");
        let part = format!("bad.fmu: {function}: found no return within");
        let limit = ["--call-timeout", "0.3"];
        let found = ends(function, "hang", "0", &limit, &[&part]);
        assert_eq!(found, rows, "{function}");
    }
    let folder = tempfile::tempdir().unwrap();
    for (build, function) in [
        (Build::LoadExits, "loading of the library"),
        (Build::InstanceExits, "fmi2Instantiate"),
    ] {
        pack(&folder.path().join("bad.fmu"), build, |_| ());
        let part = format!("{function}: found the process of the FMU ended by exit status: 0");
        fails(folder.path(), &["--isolate"], 1, &[&part]);
    }
}

/// The messages without what differs from run to run: the wall time, and the folder of the unpacked FMU.
fn stable(messages: &str) -> Vec<String> {
    let lines = messages.lines().filter(|line| !line.contains("wall time"));
    let without_folder = |line: &str| match line.split_once("/fmu-") {
        Some((before, after)) => before.to_owned() + after.split_once('/').unwrap().1,
        None => line.to_owned(),
    };
    lines.map(without_folder).collect()
}

#[test]
fn failures_are_told_as_without_a_process() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let path = folder.join("bad.fmu");
    for build in [
        Build::NoInstance,
        Build::WithoutDoStep,
        Build::OtherVersion,
        Build::SetupFails,
    ] {
        pack(&path, build, |_| ());
        let plain = said(folder, &["simulate", "bad.fmu"]);
        let own = said(folder, &["simulate", "bad.fmu", "--isolate"]);
        assert_eq!(own.code, plain.code, "{}", own.error);
        assert_eq!(stable(&own.error), stable(&plain.error));
    }
    pack(&path, Build::Whole, |_| ());
    for fault in [
        "fault=fmi2DoStep:3",
        "fault=logger",
        "fault=terminate",
        "fault=half",
    ] {
        let arguments = ["simulate", "bad.fmu", "--set", fault, "--verbose"];
        let plain = said(folder, &arguments);
        let own = said(folder, &[&arguments[..], &["--isolate"]].concat());
        assert_eq!((own.code, &own.out), (plain.code, &plain.out), "{fault}");
        assert_eq!(stable(&own.error), stable(&plain.error), "{fault}");
    }
}

/// The same bytes with and without processes.
fn same(folder: &Path, arguments: &[&str]) {
    let plain = [&["simulate"], arguments, &["-o", "plain.csv"]].concat();
    let own = [&["simulate"], arguments, &["-o", "own.csv", "--isolate"]].concat();
    done(folder, &plain);
    done(folder, &own);
    let read = |name: &str| fs::read(folder.join(name)).unwrap();
    assert!(read("own.csv") == read("plain.csv"), "{arguments:?}");
    assert!(rows(&folder.join("own.csv")) > 10);
    for name in ["plain.csv", "own.csv"] {
        fs::remove_file(folder.join(name)).unwrap();
    }
}

#[test]
fn outputs_are_the_same_bytes_with_and_without_a_process() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for name in ["a", "b"] {
        pack(&folder.join(format!("{name}.fmu")), Build::Whole, |xml| {
            *xml = xml
                .replace("<Real unit=\"m\"", "<Real")
                .replace("<Real unit=\"N\"", "<Real");
        });
    }
    let drive = "time,force[1],level\n0,1,low\n1,-0.3,high\n2,7,low\n";
    fs::write(folder.join("drive.csv"), drive).unwrap();
    same(
        folder,
        &["a.fmu", "--input", "drive.csv", "--set", "label=x"],
    );
    let pair = ["a.fmu", "b.fmu", "--connect", "a.mass.x=b.force[1]"];
    let back = ["--connect", "b.mass.x=a.force[1]", "--set", "b.mass.x=-0.5"];
    for coupling in ["jacobi", "gauss-seidel", "iterated"] {
        same(
            folder,
            &[&pair[..], &back, &["--coupling", coupling]].concat(),
        );
    }
    // With the best iterate restored at the end of each step.
    let cut = [
        "--coupling",
        "iterated",
        "--max-iterations",
        "2",
        "--step",
        "0.1",
    ];
    let kept = ["--coupling-tolerance", "1e-15", "--accept-unconverged"];
    same(folder, &[&pair[..], &back, &cut, &kept].concat());
    for version in [2, 3] {
        pack_reference_of(folder, "Feedthrough", version);
        same(folder, &["Feedthrough.fmu"]);
    }
    pack_reference_of(folder, "StateSpace", 3);
    same(folder, &["StateSpace.fmu"]);
}

#[test]
fn what_an_fmu_prints_is_not_among_the_outputs() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    pack(&folder.join("a.fmu"), Build::Whole, |_| ());
    let quiet = done(folder, &["simulate", "a.fmu"]);
    let print = [
        "simulate",
        "a.fmu",
        "--set",
        "fault=fmi2DoStep:print",
        "--isolate",
    ];
    let loud = done(folder, &print);
    assert_eq!(loud.out, quiet.out);
    // Nor does it read what is meant for its process: -1 is the end of the input.
    let lines = loud.error.lines();
    let lines = lines.filter(|line| *line == "from the library, -1");
    assert_eq!(lines.count(), 40, "{}", loud.error);
}

/// Processes whose command line has `word`.
fn processes(word: &str) -> Vec<String> {
    let listed = Command::new("ps")
        .args(["-eo", "pid,ppid,args"])
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&listed.stdout).into_owned();
    let own = text.lines().filter(|line| line.contains(word));
    own.map(str::to_owned).collect()
}

fn send(signal: &str, id: &str) {
    let sent = Command::new("kill").args([signal, id]).status().unwrap();
    assert!(sent.success(), "{signal} {id}");
}

/// Ends `simulate --isolate` of an FMU that hangs; nothing must be left of it.
fn end_of_one_that_hangs(signals: &[&str], code: Option<i32>) {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    pack(&folder.join("bad.fmu"), Build::Whole, |_| ());
    let temporary = folder.join("tmp");
    fs::create_dir(&temporary).unwrap();
    let arguments = ["simulate", "bad.fmu", "--isolate", "-o", "out.csv"];
    let fault = ["--set", "fault=fmi2DoStep:hang", "--set", "faultTime=0.2"];
    let mut started = command(folder, &[&arguments[..], &fault].concat());
    let started = started.env("TMPDIR", &temporary).stderr(Stdio::null());
    let mut child = started.spawn().unwrap();
    let until = |what: &str, done: &dyn Fn() -> bool| {
        let began = Instant::now();
        while !done() {
            assert!(
                began.elapsed() < Duration::from_secs(60),
                "{what}: {signals:?}"
            );
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    let id = child.id().to_string();
    let own = || {
        let served = processes("serve-fmu").into_iter();
        let own = served.filter(|line| line.split_whitespace().nth(1) == Some(&id));
        own.map(|line| line.split_whitespace().next().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    let five = || fs::read_to_string(folder.join("out.csv")).is_ok_and(|t| t.lines().count() == 6);
    until("rows", &five);
    let served = own();
    assert_eq!(served.len(), 1);
    for signal in signals {
        // As from a terminal: the process of the FMU gets it too.
        if *signal != "-KILL" {
            send(signal, &served[0]);
        }
        send(signal, &id);
        std::thread::sleep(Duration::from_millis(300));
    }
    assert_eq!(child.wait().unwrap().code(), code, "{signals:?}");
    // What ended and was not waited for by its new parent is gone too.
    let gone = || {
        let state = ["-o", "stat=", "-p", &served[0]];
        let state = Command::new("ps").args(state).output().unwrap().stdout;
        state.is_empty() || state.starts_with(b"Z")
    };
    until("the FMU's process", &gone);
    assert_eq!(rows(&folder.join("out.csv")), 5);
    let unpacked = fs::read_dir(&temporary).unwrap().count();
    assert!(
        code.is_none() || unpacked == 0,
        "{signals:?} leaves {unpacked}"
    );
}

#[test]
fn nothing_is_left_of_a_simulation_that_is_ended() {
    end_of_one_that_hangs(&["-INT", "-INT"], Some(130));
    end_of_one_that_hangs(&["-KILL"], None);
}

#[test]
fn an_interrupted_simulation_ends_at_its_next_point() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    pack(&folder.join("a.fmu"), Build::Whole, |_| ());
    let arguments = [
        "simulate",
        "a.fmu",
        "--isolate",
        "-o",
        "out.csv",
        "--stop",
        "1e4",
    ];
    let mut started = command(folder, &arguments);
    let child = started.stderr(Stdio::piped()).spawn().unwrap();
    while !fs::metadata(folder.join("out.csv")).is_ok_and(|file| file.len() > 1000) {
        std::thread::sleep(Duration::from_millis(10));
    }
    let id = child.id().to_string();
    for line in processes("serve-fmu") {
        let mut words = line.split_whitespace();
        let (own, parent) = (words.next().unwrap(), words.next().unwrap());
        if parent == id {
            send("-TERM", own);
            send("-TERM", parent);
        }
    }
    let output = child.wait_with_output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{error}");
    assert!(error.contains("interrupted at "), "{error}");
    assert!(!error.contains('×'), "{error}");
    assert!(rows(&folder.join("out.csv")) > 5);
}

#[test]
fn the_process_of_an_fmu_is_for_simulate_alone() {
    let folder = tempfile::tempdir().unwrap();
    let refused = said(folder.path(), &["serve-fmu"]);
    assert_eq!(refused.code, Some(2), "{}", refused.error);
    assert!(
        refused.error.contains("simulate --isolate"),
        "{}",
        refused.error
    );
}
