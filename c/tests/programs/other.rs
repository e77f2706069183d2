//! A library made by Rust that a program has beside couplet. It catches a panic of its own.

#![crate_type = "staticlib"]

/// 0 if that of a slice too short was caught, else what stands there.
#[unsafe(no_mangle)]
pub extern "C" fn other_catches(length: u8) -> u8 {
    std::panic::set_hook(Box::new(|_| ()));
    let numbers: Vec<u8> = (0..length).collect();
    std::panic::catch_unwind(|| numbers[7]).unwrap_or(0)
}
