//! The clock of work.

/// Processor time of this thread so far; where the system does not tell, time since the first call.
pub fn processor_time() -> std::time::Duration {
    use std::time::Instant;
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    cpu_time::ThreadTime::try_now()
        .map(|time| time.as_duration())
        .unwrap_or_else(|_| START.get_or_init(Instant::now).elapsed())
}
