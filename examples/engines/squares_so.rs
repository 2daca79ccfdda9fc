//! An engine for `lgs check --engine-so` in Rust: whole squares, recomputed at each commit. Of a crate it is the type
//! `cdylib`. A panic must not leave a function; since Rust 1.81 one that tries to ends the process, which is reported
//! as a crash.
//!
//!     rustc --edition 2021 -O --crate-type cdylib examples/engines/squares_so.rs -o squares.so
//!     lgs check --engine-so squares.so --edits 2000
use std::collections::HashMap;
use std::ffi::{c_char, c_void, CStr, CString};

#[repr(C)]
pub struct Segment {
    ends: [[i64; 2]; 2], // start, end
    ghosts: [[i64; 2]; 2],
    block: u32,
    missing: u32, // 3: both ghosts
}

#[repr(C)]
pub struct Answer {
    to: *mut c_void,
    refused: extern "C" fn(*mut c_void, *const c_char, *const c_char),
    segments: extern "C" fn(*mut c_void, *const Segment, usize),
    changed: extern "C" fn(*mut c_void, c_char, u64, *const Segment),
}

#[repr(C)]
pub struct Table {
    version: u32,
    name: *const c_char,
    capabilities: *const c_char,
    create: extern "C" fn() -> *mut Squares,
    destroy: unsafe extern "C" fn(*mut Squares),
    reset: extern "C" fn(&mut Squares),
    preserve: extern "C" fn(&mut Squares, u32, u32),
    add: unsafe extern "C" fn(&mut Squares, *const c_char, i32, i32, u32, *const i32, usize),
    remove: unsafe extern "C" fn(&mut Squares, *const c_char),
    commit: extern "C" fn(&mut Squares, &Answer),
}
unsafe impl Sync for Table {} // its pointers are of constants

#[derive(Default)]
pub struct Squares {
    blocks: HashMap<(i64, i64), u32>,
    cells: HashMap<CString, (i64, i64)>, // by name
}

extern "C" fn create() -> *mut Squares {
    Box::into_raw(Box::default())
}
unsafe extern "C" fn destroy(squares: *mut Squares) {
    drop(Box::from_raw(squares));
}
extern "C" fn reset(squares: &mut Squares) {
    *squares = Squares::default();
}
extern "C" fn preserve(_: &mut Squares, _: u32, _: u32) {}

unsafe extern "C" fn add(s: &mut Squares, name: *const c_char, i: i32, j: i32, block: u32, _: *const i32, _: usize) {
    let cell = (i.into(), j.into());
    s.blocks.insert(cell, block);
    s.cells.insert(CStr::from_ptr(name).to_owned(), cell);
}
unsafe extern "C" fn remove(s: &mut Squares, name: *const c_char) {
    if let Some(cell) = s.cells.remove(CStr::from_ptr(name)) {
        s.blocks.remove(&cell);
    }
}

extern "C" fn commit(s: &mut Squares, answer: &Answer) {
    for (&(i, j), &block) in &s.blocks {
        let mut end = [i * 65536, j * 65536]; // lattice units
        for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1)] {
            let start = end; // counter-clockwise, so the cell beyond is on the right
            end = [start[0] + dx * 65536, start[1] + dy * 65536];
            if !s.blocks.contains_key(&(i + dy, j - dx)) {
                let side = Segment { ends: [start, end], ghosts: [[0; 2]; 2], block, missing: 3 };
                (answer.segments)(answer.to, &side, 1);
            }
        }
    }
}

#[no_mangle]
pub extern "C" fn lgs_engine() -> *const Table {
    static TABLE: Table = Table {
        version: 1,
        name: b"squares.rs\0".as_ptr() as *const c_char,
        capabilities: b"squares blocks\0".as_ptr() as *const c_char,
        create, destroy, reset, preserve, add, remove, commit,
    };
    &TABLE
}
