//! The name that programs look for the shared library by. Its number rises when a program that was linked with it could
//! not go on.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,libcouplet_c.so.0");
    }
}
