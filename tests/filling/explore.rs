use sphere_dda::scene::Scene;
use std::path::Path;
#[test]
fn explore() {
    let args = std::env::var("ARGS").unwrap();
    for arg in args.split(';') {
        let text = format!(
            r#"
[simulation]
duration = 1.0
step = 1e-3
[[material]]
name = "rock"
density = 2500.0
[[spheres]]
name = "grains"
material = "rock"
{arg}
"#
        );
        let t = std::time::Instant::now();
        match Scene::from_toml("scene.toml", &text, Path::new("")) {
            Ok(l) => eprintln!("{arg} => {} {:?}", l.scene.particles.len(), t.elapsed()),
            Err(e) => eprintln!("{arg} => {} {:?}", e.plain(), t.elapsed()),
        }
    }
}
