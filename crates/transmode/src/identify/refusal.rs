//! What the library refuses, in terms of the command line.

use reconstruct::ReconstructError;

use crate::CommandError;
use crate::error::OptionError;

/// One sentence that names the option at fault, where an option is.
pub(super) fn sentence(error: &ReconstructError, noise: Option<&str>) -> CommandError {
    let option = match error {
        ReconstructError::OrderTooHigh { record, .. }
        | ReconstructError::RecordTooShort { record, .. }
        | ReconstructError::ConstantChannel { record, .. }
        | ReconstructError::ZeroRecord { record }
            if noise == Some(record.as_str()) =>
        {
            "--noise-record"
        }
        ReconstructError::DifferentSampling { second, .. }
        | ReconstructError::DifferentChannels { second, .. }
            if noise == Some(second.as_str()) =>
        {
            "--noise-record"
        }
        ReconstructError::SilentRecord { .. } => "--noise-record",
        ReconstructError::Noise { .. } if noise.is_some() => "--noise-record",
        ReconstructError::OrderTooHigh { .. }
        | ReconstructError::InvalidOrder { .. }
        | ReconstructError::TooFewBlockRows { .. } => "--order",
        ReconstructError::NoiseLevelCount { .. } | ReconstructError::InvalidNoiseLevel { .. } => {
            "--noise"
        }
        ReconstructError::Option { name, message } => match *name {
            "known inputs" | "recorded inputs" => return refused("--inputs", message.clone()),
            "structure" => return refused("--structure", message.clone()),
            "band" => return refused("--band", message.clone()),
            "deviations of offsets" => return refused("--offsets", message.clone()),
            "noise levels" => return refused("--noise", message.clone()),
            "feedthrough sensors" => return refused("--feedthrough", message.clone()),
            _ => return CommandError::Reconstruct(error.to_string()),
        },
        _ => return CommandError::Reconstruct(error.to_string()),
    };
    refused(option, error.to_string())
}

fn refused(option: &'static str, message: String) -> CommandError {
    OptionError::Refused { option, message }.into()
}
