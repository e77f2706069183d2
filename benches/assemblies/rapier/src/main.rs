//! Rapier asked one question: an assembly of stones as JSON on standard input, `true` or `false` on standard output.

use rapier2d_f64::prelude::*;
use serde::Deserialize;
use std::error::Error;

/// An assembly whose radius is 1, with what is asked of the engine.
#[derive(Deserialize)]
struct Asked {
    friction: f64,
    polygons: Vec<[[f64; 2]; 4]>,
    centroids: Vec<[f64; 2]>,
    weights: Vec<f64>,
    inertias: Vec<f64>,
    supports: [[[f64; 2]; 4]; 2],
    gravity: f64,
    seconds: f64,
    step: f64,
    iterations: usize,
    error: f64,
    frequency: f64,
    moved: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", stands(&serde_json::from_reader(std::io::stdin())?)?);
    Ok(())
}

/// Corners about a point, with the friction of the joints and no mass.
fn shape(
    polygon: &[[f64; 2]; 4],
    about: [f64; 2],
    friction: f64,
) -> Result<Collider, Box<dyn Error>> {
    let points: Vec<_> =
        polygon.iter().map(|[x, y]| Vector::new(x - about[0], y - about[1]).into()).collect();
    let hull = ColliderBuilder::convex_hull(&points).ok_or("no hull")?;
    Ok(hull.friction(friction).density(0.0).build())
}

fn stands(asked: &Asked) -> Result<bool, Box<dyn Error>> {
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    for ground in &asked.supports {
        colliders.insert(shape(ground, [0.0, 0.0], asked.friction)?);
    }
    let mut stones = Vec::new();
    for (place, polygon) in asked.polygons.iter().enumerate() {
        let [x, y] = asked.centroids[place];
        let mass = MassProperties::new(
            Vector::new(0.0, 0.0).into(),
            asked.weights[place],
            asked.inertias[place],
        );
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(x, y))
            .additional_mass_properties(mass)
            .can_sleep(false);
        let handle = bodies.insert(body);
        let stone = shape(polygon, [x, y], asked.friction)?;
        colliders.insert_with_parent(stone, handle, &mut bodies);
        stones.push(handle);
    }
    let mut pipeline = PhysicsPipeline::new();
    let parameters = IntegrationParameters {
        dt: asked.step,
        num_solver_iterations: asked.iterations,
        // Usual is a millimetre of each metre, which is as much as a joint may open before the arch is another.
        normalized_allowed_linear_error: asked.error,
        contact_softness: SpringCoefficients::new(asked.frequency, 5.0),
        ..IntegrationParameters::default()
    };
    let (mut islands, mut broad, mut narrow) =
        (IslandManager::new(), DefaultBroadPhase::new(), NarrowPhase::new());
    let (mut joints, mut multibody, mut ccd) =
        (ImpulseJointSet::new(), MultibodyJointSet::new(), CCDSolver::new());
    for _ in 0..(asked.seconds / asked.step).round() as u64 {
        pipeline.step(
            Vector::new(0.0, -asked.gravity),
            &parameters,
            &mut islands,
            &mut broad,
            &mut narrow,
            &mut bodies,
            &mut colliders,
            &mut joints,
            &mut multibody,
            &mut ccd,
            &(),
            &(),
        );
        let stays = stones.iter().zip(&asked.centroids).all(|(stone, [x, y])| {
            let at = bodies[*stone].translation();
            (at.x - x).hypot(at.y - y) <= asked.moved
        });
        if !stays {
            return Ok(false);
        }
    }
    Ok(true)
}
