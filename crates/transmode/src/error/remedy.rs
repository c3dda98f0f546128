//! What a person can do where the operating system refuses.

use std::io::{Error, ErrorKind};

/// Where a file cannot be read.
pub(super) fn of_reading(error: &Error) -> &'static str {
    match error.kind() {
        ErrorKind::NotFound => "check its name and folder",
        ErrorKind::PermissionDenied => "ask its owner for the right to read it",
        ErrorKind::IsADirectory => "name a file in it",
        ErrorKind::NotADirectory => {
            "what stands before the last slash is no folder; check the name"
        }
        ErrorKind::InvalidData | ErrorKind::UnexpectedEof => {
            "it may be damaged or cut off; copy it again"
        }
        _ => "try it again, or from a copy on another disk",
    }
}

/// Where a file or folder cannot be written.
pub(super) fn of_writing(error: &Error) -> &'static str {
    match error.kind() {
        ErrorKind::NotFound => "make its folder first, or name another",
        ErrorKind::PermissionDenied => "name a place where you may write",
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => {
            "make room, or name a place that has some"
        }
        ErrorKind::IsADirectory => "choose another name",
        ErrorKind::NotADirectory | ErrorKind::AlreadyExists => {
            "a file stands where a folder is needed; choose another name"
        }
        _ => "name another place",
    }
}
