//! What was found, for the terminal.

use std::fmt::Write;

use report::format_significant;

use super::outcome::{MonitorOutcome, Watched};
use super::reference::Reference;

/// The reference, what the alarms mean, and each record.
pub(super) fn render(outcome: &MonitorOutcome) -> String {
    let reference = &outcome.reference;
    let detector = &reference.detector;
    let (mut text, span_s) = (String::new(), reference.span_s());
    let models = if reference.given { "models from files" } else { "models from its first half" };
    let _ = writeln!(
        text,
        "reference: {}, {} samples, every {} s; {models}, limits from {} spans of its second half",
        reference.name,
        reference.samples,
        reference.period_s,
        detector.healthy_windows()
    );
    let pairs: Vec<String> = reference.pairs().map(|pair| pair.join(" to ")).collect();
    let _ = writeln!(text, "pairs: {}", pairs.join(", "));
    let _ = writeln!(
        text,
        "false alarms: a chance of {} in each span of {} s of a healthy record, {} in an hour",
        format_significant(detector.options().false_alarms, 3),
        format_significant(span_s, 4),
        format_significant(reference.false_alarms_per_hour(), 2)
    );
    for watched in &outcome.watched {
        let _ = writeln!(text, "\n{}", record(reference, watched));
    }
    for warning in &outcome.warnings {
        let _ = writeln!(text, "{}: {warning}", warning.label());
    }
    if reference.fitted_to_itself {
        let _ = writeln!(
            text,
            "warning: a model was fitted to the reference itself, so that the limits are too narrow; give another healthy record"
        );
    }
    text
}

fn record(reference: &Reference, watched: &Watched) -> String {
    let spans = watched.windows.len();
    let lost = match watched.not_judged {
        0 => String::new(),
        1 => "; 1 more is not judged, too many of its samples are missing".to_owned(),
        lost => format!("; {lost} more are not judged, too many of their samples are missing"),
    };
    let alarm = watched.diagnosis.as_ref().and_then(|diagnosis| {
        let window = watched.windows.get(diagnosis.first_alarm)?;
        Some((diagnosis, window, window.alarm()?))
    });
    let Some((diagnosis, window, (kind, test))) = alarm else {
        return format!("{}: no alarm in {spans} spans{lost}", watched.name);
    };
    let time = |sample| reference.time(watched.start_s, sample);
    let mut text = format!(
        "{}: alarm at {} s; {} of {spans} spans raise one{lost}\n  first: the span from {} s, test of {kind}, T^2 {} above its limit {}\n  change: {}\n  sensor: ",
        watched.name,
        time(window.known_at),
        diagnosis.alarms,
        time(window.first),
        format_significant(test.statistic, 4),
        format_significant(test.limit, 4),
        diagnosis.change,
    );
    let suspects: Vec<&str> =
        diagnosis.suspects.iter().map(|channel| reference.sensor(*channel)).collect();
    text += &match suspects.split_first() {
        None => {
            "none alone explains it; several are at fault, or the excitation is another".to_owned()
        }
        Some((first, [])) => (*first).to_owned(),
        Some((first, others)) => format!("{first}, or {}", others.join(", ")),
    };
    text
}
