//! What the page asks.

use serde::Deserialize;
use std::collections::BTreeMap;

/// What is to be proved of an arch, in texts that the command line reads too, and where its root seems to be.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Question {
    /// `heyman` or `milankovitch`.
    pub weight: String,
    /// In radians, or with `deg` or `pi`.
    pub half_opening: Option<String>,
    /// Instead of it, lengths with units.
    pub span: Option<String>,
    /// With the span.
    pub rise: Option<String>,
    /// A length with its unit, beside a half opening.
    pub radius: Option<String>,
    /// The circle of these: the intrados if not given.
    pub measured_at: Option<String>,
    /// A coefficient, an angle with its unit, or `inf`.
    pub friction: Option<String>,
    /// The thickness of the arch: a ratio (`0.1`, `0.1r`); with span and rise a length, or a ratio with its `r`.
    pub thickness: Option<String>,
    /// The label of a mode, `slides` or `too_wide`.
    pub subject: String,
    /// A start for each unknown, by its name.
    pub start: BTreeMap<String, f64>,
    /// How many digits are wanted; fewer are given where these are not decided.
    pub digits: usize,
    /// Whether the certificate is wanted, checked in the second arithmetic too.
    pub file: bool,
    /// `still` or `moving` for a picture.
    pub drawing: Option<String>,
}
