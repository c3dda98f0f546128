//! What two or more tasks use. Nothing here knows a task, and no task imports another.

pub(crate) mod page;
