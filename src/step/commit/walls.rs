//! What the triangles of boundaries feel in a solved step: a contact counts on the triangle on which its closest point lies at the
//! start of the step, on an edge or a corner in equal parts on all that meet there.

use crate::Vec3;
use crate::contact::{ContactForce, ContactId, Partner};
use crate::state::{State, TriangleLoads, Wall, WallLoad};
use crate::step::commit::energy::End;
use crate::step::solution::Solved;

/// The smooth loads that stand where a step is the `remainder` of another; none where it is not.
pub(super) fn smooth_loads(state: &State, remainder: bool) -> Vec<TriangleLoads> {
    let walls = state.walls.list.iter().filter(|_| remainder);
    walls.map(|wall| wall.smooth.clone()).collect()
}

/// Puts [`smooth_loads`] back.
pub(super) fn keep_smooth(state: &mut State, loads: Vec<TriangleLoads>) {
    for (wall, smooth) in state.walls.list.iter_mut().zip(loads) {
        wall.smooth = smooth;
    }
}

impl Solved<'_> {
    /// Adds what a contact does to the loads of its triangles.
    pub(crate) fn press(&self, state: &mut State, load: &ContactForce, smooth: bool) {
        if let Some((b, loads)) = self.loads(state, load) {
            let wall = &mut state.walls.list[b];
            if smooth {
                wall.smooth.extend(&loads);
            }
            wall.loads.extend(loads);
        }
    }

    /// Adds what a contact does to what persists of the loads of its triangles.
    pub(crate) fn press_smooth(&self, state: &mut State, load: &ContactForce) {
        if let Some((b, loads)) = self.loads(state, load) {
            state.walls.list[b].smooth.extend(loads);
        }
    }

    /// Gives the triangles of the contact `at` an impulse \[N s\].
    pub(crate) fn strike(&self, state: &mut State, at: &ContactForce, impulse: Vec3) {
        let load = ContactForce {
            force: -impulse,
            ..*at
        };
        if let Some((b, loads)) = self.loads(state, &load) {
            Wall::press(&mut state.walls.list[b].triangles, &loads, 1.0);
        }
    }

    /// The boundary of a contact, and its equal parts on the triangles that feel it; `None` unless they keep it.
    fn loads(&self, state: &State, load: &ContactForce) -> Option<(usize, TriangleLoads)> {
        let (b, triangles) = self.triangles(state, load.key, load.normal)?;
        let mut share = WallLoad::default();
        share.add(&WallLoad::of(load), 1.0 / triangles.len() as f64);
        let loads = triangles.into_iter().map(|triangle| (triangle, share));
        Some((b, loads.collect()))
    }

    /// Adds what contacts lose, and what they wear off.
    pub(super) fn wear(&self, state: &mut State, end: Option<&End>) {
        if state.walls.list.is_empty() {
            return;
        }
        for k in 0..self.solution.impulses.len() {
            let Some(contact) = self.assembly.contact_of(k) else {
                continue;
            };
            let elastic = self.assembly.elastic(k);
            if !self.solution.loads(k) && elastic.is_none() {
                continue;
            }
            let candidate = &self.assembly.candidates[contact];
            let place = self.triangles(state, candidate.key, candidate.normal);
            let Some((b, triangles)) = place else {
                continue;
            };
            let lost = self.lost(k);
            let sprung = elastic.zip(end);
            let sprung = sprung
                .map(|(elastic, end)| self.work_of_spring(k, elastic, (end, &state.contacts)));
            let [damped, returned] = sprung.map_or([0.0; 2], |work| [work.damped, work.slid()]);
            let share = 1.0 / triangles.len() as f64;
            let wear = self.prediction().pair(candidate.key).wear;
            for triangle in triangles {
                let sums = &mut state.walls.list[b].triangles[triangle as usize];
                sums.friction += (lost.friction + returned) * share;
                sums.impact += (lost.impact + damped) * share;
                sums.wear += wear * lost.impulse * lost.slip.norm() * share;
            }
        }
    }

    /// The boundary of a contact and which of its triangles feel it; `None` unless they keep it.
    fn triangles(&self, state: &State, key: ContactId, normal: Vec3) -> Option<(usize, Vec<u32>)> {
        let Partner::Boundary { boundary, feature } = key.partner else {
            return None;
        };
        let b = usize::from(boundary);
        if !state.walls.list.get(b)?.is_kept() {
            return None;
        }
        let (prediction, i) = (self.prediction(), key.sphere as usize);
        let (scene, pose) = (prediction.scene, &prediction.poses[0][b]);
        let boundary = &scene.boundaries[b];
        let centre = boundary.copy_near(&scene.cell, pose, prediction.kinematics.position[i]);
        let (x, n) = (
            boundary.to_frame(pose, centre),
            pose.rotation.inverse() * normal,
        );
        let radius = scene.particles.radius[i];
        let geometry = &boundary.geometry;
        let mut triangles = Vec::new();
        let point = geometry.follow(feature, n, x, radius).point;
        geometry.triangles_at(feature, point, &mut triangles);
        (!triangles.is_empty()).then_some((b, triangles))
    }
}
