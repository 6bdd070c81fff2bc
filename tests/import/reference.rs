//! The Reference FMUs of the Modelica Association, against the recursions that their sources state.

use sphere_dda_master::{Coupling, End, Fmu, InputTable, Options, System, Table, Values};

use crate::foreign_fmu::{pack_reference, pack_reference_of};
use crate::{drive, run};

fn reference(model: &str, version: u32) -> (tempfile::TempDir, Fmu) {
    let folder = tempfile::tempdir().unwrap();
    let fmu = Fmu::open(pack_reference_of(folder.path(), model, version)).unwrap();
    assert_eq!(fmu.missing_functions().unwrap(), [""; 0]);
    (folder, fmu)
}

fn integers<'t>(table: &'t Table, name: &str) -> &'t [i64] {
    match &table
        .columns
        .iter()
        .find(|column| column.name == name)
        .unwrap()
        .values
    {
        Values::Integer(values) => values,
        values => panic!("{name}: {values:?}"),
    }
}

/// x' = -k x by explicit Euler steps of 0.1 s: x_n = (1 - 0.1 k)^n.
#[test]
fn dahlquist_decays_as_its_euler_steps() {
    [2, 3]
        .into_iter()
        .for_each(dahlquist_decays_as_its_euler_steps_in);
}

fn dahlquist_decays_as_its_euler_steps_in(version: u32) {
    let (_folder, fmu) = reference("Dahlquist", version);
    for k in [1.0, 0.3, 15.0_f64] {
        let options = Options {
            set: vec![
                ("k".to_owned(), k.to_string()),
                ("x".to_owned(), "2".to_owned()),
            ],
            ..Options::default()
        };
        let table = run(&fmu, &options).unwrap();
        assert_eq!((table.end, table.time.len()), (End::Stop, 101));
        for (n, x) in table.real("x").unwrap().iter().enumerate() {
            let exact = 2.0 * (1.0 - 0.1 * k).powi(n as i32);
            assert!(
                (x - exact).abs() <= 1e-12 * exact.abs(),
                "k {k} row {n}: {x}"
            );
        }
    }
}

/// x0' = x1, x1' = (1 - x0^2) x1 - x0 by explicit Euler steps of 0.01 s.
#[test]
fn van_der_pol_equals_its_euler_steps() {
    [2, 3]
        .into_iter()
        .for_each(van_der_pol_equals_its_euler_steps_in);
}

fn van_der_pol_equals_its_euler_steps_in(version: u32) {
    let (_folder, fmu) = reference("VanDerPol", version);
    let table = run(&fmu, &Options::default()).unwrap();
    assert_eq!(table.time.len(), 2001);
    let [mut x0, mut x1] = [2.0, 0.0];
    let (found0, found1) = (table.real("x0").unwrap(), table.real("x1").unwrap());
    for n in 0..=2000 {
        assert!(
            (found0[n] - x0).abs() + (found1[n] - x1).abs() < 1e-9,
            "row {n}"
        );
        [x0, x1] = [x0 + 0.01 * x1, x1 + 0.01 * ((1.0 - x0 * x0) * x1 - x0)];
    }
}

/// The counter is 1 + floor(t); at 10 the FMU wants to end.
#[test]
fn stair_ends_the_simulation_itself() {
    [2, 3]
        .into_iter()
        .for_each(stair_ends_the_simulation_itself_in);
}

fn stair_ends_the_simulation_itself_in(version: u32) {
    let (_folder, fmu) = reference("Stair", version);
    let table = run(&fmu, &Options::default()).unwrap();
    assert_eq!(table.end, End::Terminated);
    assert!((table.time.last().unwrap() - 9.0).abs() < 0.3);
    for (t, counter) in table.time.iter().zip(integers(&table, "counter")) {
        assert_eq!(*counter as f64, 1.0 + (t + 1e-6).floor(), "at {t}");
    }
}

/// h = 1 - g t^2/2 until it hits the ground at t = sqrt(2/g), up to the Euler steps of 0.001 s.
#[test]
fn bouncing_ball_falls_and_bounces() {
    [2, 3]
        .into_iter()
        .for_each(bouncing_ball_falls_and_bounces_in);
}

fn bouncing_ball_falls_and_bounces_in(version: u32) {
    let (_folder, fmu) = reference("BouncingBall", version);
    let table = run(&fmu, &Options::default()).unwrap();
    let h = table.real("h").unwrap();
    for (t, h) in table.time.iter().zip(h).take_while(|(t, _)| **t < 0.44) {
        // n steps of explicit Euler: h_n = 1 - g dt^2 n (n - 1) / 2.
        let exact = 1.0 - 9.81 / 2.0 * t * (t - 0.001);
        assert!((h - exact).abs() < 1e-9, "at {t}: {h}");
    }
    let top = h[60..].iter().copied().fold(0.0, f64::max);
    assert!((top - 0.49).abs() < 0.03, "restitution 0.7: {top}");
}

#[test]
fn feedthrough_gives_back_values_of_every_type() {
    let (_folder, fmu) = reference("Feedthrough", 2);
    let system = System::of(&fmu);
    let text = "time,Float64_continuous_input,Float64_discrete_input,Int32_input,Boolean_input,String_input,Enumeration_input\n\
                0,1.5,-2,7,false,first,Option 1\n\
                1,2.5,3,-8,true,\"a, \"\"b\"\" %s\",Option 2\n";
    let options = Options {
        inputs: Some(InputTable::read(text.as_bytes(), "drive.csv", &system).unwrap()),
        stop: Some(1.5),
        step: Some(0.5),
        ..Options::default()
    };
    let table = drive(&system, &options).unwrap();
    // A row shows the inputs of the step before it.
    let mut csv = Vec::new();
    table.write_csv(&mut csv).unwrap();
    assert_eq!(
        String::from_utf8(csv).unwrap(),
        "time,Float64_continuous_output,Float64_discrete_output,Int32_output,Boolean_output,String_output,Enumeration_output\n\
         0.0,1.5,-2.0,7,false,first,1\n\
         0.5,1.5,-2.0,7,false,first,1\n\
         1.0,2.0,-2.0,7,false,first,1\n\
         1.5,2.5,3.0,-8,true,\"a, \"\"b\"\" %s\",2\n"
    );
}

/// Two feedthroughs in a chain behind a decay: values pass through both at initialization; with Gauss-Seidel in the
/// order of the chain also in every step, with Jacobi one late for each.
#[test]
fn values_run_through_a_chain() {
    let folder = tempfile::tempdir().unwrap();
    let source = Fmu::open(pack_reference(folder.path(), "Dahlquist")).unwrap();
    let wire = Fmu::open(pack_reference(folder.path(), "Feedthrough")).unwrap();
    for (coupling, late) in [(Coupling::Jacobi, 2), (Coupling::GaussSeidel, 0)] {
        // In the wrong order for the initialization, in the right one for the steps.
        let parts = [("source", &source), ("one", &wire), ("two", &wire)];
        let parts = parts.map(|(name, fmu)| (name.to_owned(), fmu));
        let mut system = System::coupled(parts).unwrap();
        system
            .connect([
                (
                    "one.Float64_continuous_output",
                    "two.Float64_continuous_input",
                ),
                ("source.x", "one.Float64_continuous_input"),
                ("one.String_output", "two.String_input"),
                ("one.Boolean_output", "two.Boolean_input"),
                ("one.Enumeration_output", "two.Enumeration_input"),
                ("one.Int32_output", "two.Int32_input"),
            ])
            .unwrap();
        let options = Options {
            coupling,
            stop: Some(2.0),
            set: vec![
                ("one.String_input".to_owned(), "through".to_owned()),
                ("one.Enumeration_input".to_owned(), "Option 2".to_owned()),
                ("one.Int32_input".to_owned(), "-3".to_owned()),
            ],
            ..Options::default()
        };
        let table = drive(&system, &options).unwrap();
        let (x, out) = (
            table.real("source.x").unwrap(),
            table.real("two.Float64_continuous_output").unwrap(),
        );
        assert_eq!(out[0], 1.0);
        assert_eq!(
            out[late.max(1)..],
            x[late.max(1) - late..x.len() - late],
            "{coupling:?}"
        );
        assert_eq!(integers(&table, "two.Int32_output")[0], -3);
        assert_eq!(integers(&table, "two.Enumeration_output")[5], 2);
        let text = table
            .columns
            .iter()
            .find(|column| column.name == "two.String_output")
            .unwrap();
        assert_eq!(text.values.get(0).unwrap().to_string(), "through");
    }
}

/// Every type of FMI 3.0 through its own get and set.
#[test]
fn feedthrough_gives_back_values_of_every_type_of_fmi_3() {
    let (_folder, fmu) = reference("Feedthrough", 3);
    let system = System::of(&fmu);
    let names = "Float64_continuous,Float32_continuous,Int8,UInt8,Int16,UInt16,Int32,UInt32,Int64,UInt64,Boolean,\
                 String,Binary,Enumeration";
    let values = "1.5,-0.25,-128,255,-32768,65535,-2147483648,4294967295,-9223372036854775808,9223372036854775807,\
                  true,a %s,00ff7f,2";
    let named = |end: &str| -> Vec<String> {
        let names = names.split(',');
        names.map(|name| format!("{}_{end}", name.trim())).collect()
    };
    let text = format!("time,{}\n0,{values}\n", named("input").join(","));
    let options = Options {
        inputs: Some(InputTable::read(text.as_bytes(), "drive.csv", &system).unwrap()),
        outputs: Some(named("output")),
        stop: Some(0.5),
        step: Some(0.5),
        ..Options::default()
    };
    let table = drive(&system, &options).unwrap();
    let mut csv = Vec::new();
    table.write_csv(&mut csv).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    assert_eq!(csv.lines().nth(2), Some(&*format!("0.5,{values}")));
    for bad in [
        "Int8_input=128",
        "UInt8_input=-1",
        "Binary_input=f",
        "Enumeration_input=Option 3",
    ] {
        let (name, value) = bad.split_once('=').unwrap();
        let options = Options {
            set: vec![(name.to_owned(), value.to_owned())],
            ..Options::default()
        };
        let error = run(&fmu, &options).unwrap_err().to_string();
        assert!(
            error.contains(name) && error.contains("expected"),
            "{error}"
        );
    }
}

/// x' = A x + B u by explicit Euler steps of 1 ms, y = C x + D u: whole matrices and single elements are set.
#[test]
fn state_space_takes_arrays_whole_and_element_by_element() {
    let (_folder, fmu) = reference("StateSpace", 3);
    let set = [
        ("A", "0 1 0 -0.5 -0.25 0 0 0 -1"),
        ("B[2,1]", "2"),
        ("C[1,3]", "-1"),
        ("D", "0 0 0 0 0 0 0 0 0"),
        ("u", "1 0.5 -1"),
        ("u[3]", "3"),
    ];
    let options = Options {
        set: set
            .map(|(name, value)| (name.to_owned(), value.to_owned()))
            .to_vec(),
        step: Some(1.0),
        ..Options::default()
    };
    let table = run(&fmu, &options).unwrap();
    assert_eq!(table.columns.len(), 3, "{:?}", table.columns);
    let a = [[0.0, 1.0, 0.0], [-0.5, -0.25, 0.0], [0.0, 0.0, -1.0]];
    let b = [[1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let c = [[1.0, 0.0, -1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let u = [1.0, 0.5, 3.0];
    let times =
        |m: &[[f64; 3]; 3], v: &[f64; 3]| m.map(|row| (0..3).map(|k| row[k] * v[k]).sum::<f64>());
    // The model leaves `x0` unused.
    let mut x = [0.0; 3];
    for row in 0..table.time.len() {
        let y = times(&c, &x);
        for (k, y) in y.iter().enumerate() {
            let found = table.real(&format!("y[{}]", k + 1)).unwrap()[row];
            assert!((found - y).abs() < 1e-9, "row {row}: {found} is not {y}");
        }
        for _ in 0..1000 {
            let (ax, bu) = (times(&a, &x), times(&b, &u));
            x = [0, 1, 2].map(|k| x[k] + 1e-3 * (ax[k] + bu[k]));
        }
    }
    let error = |name: &str, value: &str| {
        let options = Options {
            set: vec![(name.to_owned(), value.to_owned())],
            ..Options::default()
        };
        run(&fmu, &options).unwrap_err().to_string()
    };
    assert!(error("A", "1 2 3").contains("9 values separated by blanks"));
    assert!(error("A[4,1]", "1").contains("found `A[4,1]`"));
    assert!(error("n", "2").contains("StructuralParameter"));
}

/// Arrays are joined whole, or element by element, also with an FMU of FMI 2.0.
#[test]
fn versions_can_be_coupled() {
    let folder = tempfile::tempdir().unwrap();
    let space = Fmu::open(pack_reference_of(folder.path(), "StateSpace", 3)).unwrap();
    let decay = Fmu::open(pack_reference(folder.path(), "Dahlquist")).unwrap();
    let parts = [("decay", &decay), ("one", &space), ("two", &space)];
    let parts = parts.map(|(name, fmu)| (name.to_owned(), fmu));
    let mut system = System::coupled(parts).unwrap();
    system
        .connect([("decay.x", "one.u[2]"), ("one.y", "two.u")])
        .unwrap();
    let error = system
        .connect([
            ("one.y", "decay.x"),
            ("one.y[1]", "two.u"),
            ("one.y[1]", "two.u[1]"),
        ])
        .unwrap_err()
        .to_string();
    for part in [
        "found [3] and one value",
        "found one value and [3]",
        "connection `one.y[1]` to `two.u[1]`: the input is fed by `one.y[1]` already",
    ] {
        assert!(error.contains(part), "{part} is not in\n{error}");
    }
    let options = Options {
        coupling: Coupling::GaussSeidel,
        step: Some(1.0),
        stop: Some(4.0),
        set: ["one", "two"]
            .map(|name| (format!("{name}.A"), "0 0 0 0 0 0 0 0 0".to_owned()))
            .to_vec(),
        ..Options::default()
    };
    let table = drive(&system, &options).unwrap();
    let value = |name: &str| table.real(name).unwrap();
    // With A = 0, B = C = D = 1 from x0 = 0: y = u + h (the sum of u at the steps before).
    let mut sum = [0.0, 0.0];
    for row in 1..5 {
        let u = value("decay.x")[row];
        sum[0] += u;
        assert!(
            (value("one.y[2]")[row] - (u + sum[0])).abs() < 1e-12,
            "row {row}"
        );
        let v = value("one.y[2]")[row];
        sum[1] += v;
        assert!(
            (value("two.y[2]")[row] - (v + sum[1])).abs() < 1e-12,
            "row {row}"
        );
        assert!(
            (value("one.y[1]")[row] - (1.0 + row as f64)).abs() < 1e-12,
            "row {row}"
        );
    }
}
