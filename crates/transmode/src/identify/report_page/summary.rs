//! The answer in a few sentences, what speaks against it, and the command that gave it.

use aircraft::ModeName;
use reconstruct::Method;
use report::{Block, format_significant};

use crate::CommandError;
use crate::identify::doubts;
use crate::identify::outcome::Outcome;
use crate::modes::IdentifiedMode;
use crate::numbers::counted;

pub(super) fn blocks(input: &Outcome<'_>) -> Result<Vec<Block>, CommandError> {
    let mut blocks = vec![Block::paragraph(sentences(input))];
    let doubts = doubts::said(input);
    let causes: Vec<String> = doubts::all_causes(&doubts)
        .into_iter()
        .map(|cause| format!("Possible cause: {}", cause.text))
        .collect();
    let doubts = doubts.into_iter().map(|doubt| doubt.text);
    let all = input.warnings.iter().map(ToString::to_string).chain(doubts).chain(causes);
    blocks.extend(all.map(|text| Block::warning(sentence(&text))));
    blocks.push(Block::code("sh", input.command));
    Ok(blocks)
}

fn sentences(input: &Outcome<'_>) -> String {
    let records = counted(input.records.len() as u64, "record");
    let channels = input.records.first().map_or(&[][..], |record| record.channels());
    let names: Vec<&str> = channels.iter().map(|channel| channel.name.as_str()).collect();
    let order = input.found.iter().map(states).sum::<usize>();
    let found: Vec<String> = input.found.iter().map(mode).collect();
    let what = match found.is_empty() {
        true => "No mode was found".to_owned(),
        false => format!(
            "{} with {} together: {}",
            counted(found.len() as u64, "mode"),
            counted(order as u64, "state"),
            found.join("; ")
        ),
    };
    let count = input.warnings.len() + input.result.doubts.len();
    let trust = match (input.result.doubts.is_empty(), count) {
        (true, 0) => "Nothing found in the records speaks against the result.".to_owned(),
        (true, _) => "What is below concerns the files, not the result.".to_owned(),
        (false, _) => {
            "**The result should not be trusted as it is**, for what is said below.".to_owned()
        }
    };
    let given = if input.result.output_error().is_some() {
        format!(", with inputs {}", input.options.inputs.names.join(", "))
    } else {
        ", of which nobody gave the excitation".to_owned()
    };
    format!(
        "{what}. Found by {} in {records} of {} ({}){given}. {trust}",
        method(input.result.method()),
        counted(names.len() as u64, "sensor"),
        names.join(", ")
    )
}

/// States that a mode takes.
fn states(found: &IdentifiedMode) -> usize {
    // A real eigenvalue in z below zero oscillates, too, and is one state.
    let z = found.mode.mode.discrete_eigenvalue;
    if z.map_or(found.mode.mode.eigenvalue.im, |z| z.im) > 0.0 { 2 } else { 1 }
}

/// `Dutch roll at 1.69 rad/s with a damping ratio of 0.042`.
fn mode(found: &IdentifiedMode) -> String {
    let (mode, number) = (&found.mode.mode, |value: f64| format_significant(value, 3));
    let name = match found.named.name {
        ModeName::Unnamed(_) => "a mode without a name".to_owned(),
        ModeName::Oscillatory => "an oscillatory mode".to_owned(),
        ModeName::Real => "a real mode".to_owned(),
        ModeName::Integrator => "an integrator".to_owned(),
        name => name.to_string(),
    };
    if mode.period_s.is_some() {
        return format!(
            "{name} at {} rad/s with a damping ratio of {}",
            number(mode.natural_frequency_rad_s),
            number(mode.damping_ratio)
        );
    }
    let verb = if mode.eigenvalue.re > 0.0 { "doubling" } else { "halving" };
    format!("{name}, {verb} in {} s", number(mode.time_to_half_or_double_s))
}

pub(super) fn method(method: Method) -> &'static str {
    match method {
        Method::Paper => "the method as printed",
        Method::Subspace => "the intersection of signal subspaces",
        Method::OutputError => "output error with recorded inputs",
        _ => "maximum likelihood",
    }
}

/// With a capital letter and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
    let stop = if text.ends_with('.') { "" } else { "." };
    format!("{first}{}{stop}", letters.as_str())
}
