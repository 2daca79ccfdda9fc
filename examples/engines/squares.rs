//! An engine for `lgs check --engine` in Rust, from the page of the protocol alone: whole squares, recomputed at each
//! commit. It has no dependencies:
//!
//!     rustc -O examples/engines/squares.rs -o squares && lgs check --engine ./squares --edits 2000
use std::collections::HashMap;
use std::io::{stdin, stdout, BufRead, Result, Write};

type Cell = (i64, i64);

const UNITS: i64 = 65536; // of the lattice, in a cell
// Of a cell: from corner to corner, the solid on the left; and the cell beyond.
const SIDES: [[Cell; 3]; 4] = [
    [(0, 0), (1, 0), (0, -1)],
    [(1, 0), (1, 1), (1, 0)],
    [(1, 1), (0, 1), (0, 1)],
    [(0, 1), (0, 0), (-1, 0)],
];

fn outline(cells: &HashMap<Cell, String>, out: &mut impl Write) -> Result<()> {
    for (&(i, j), block) in cells {
        for [from, to, beyond] in SIDES {
            if cells.contains_key(&(i + beyond.0, j + beyond.1)) {
                continue;
            }
            let [sx, sy, ex, ey] = [i + from.0, j + from.1, i + to.0, j + to.1].map(|corner| corner * UNITS);
            writeln!(out, "segment {sx} {sy} {ex} {ey} - - - - {block}")?;
        }
    }
    writeln!(out, "end")
}

fn main() -> Result<()> {
    let mut cells: HashMap<Cell, String> = HashMap::new(); // with their blocks
    let mut cell_of: HashMap<String, Cell> = HashMap::new(); // by name
    let mut out = stdout().lock();
    for line in stdin().lock().lines() {
        let line = line?;
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["lgs-engine", ..] => writeln!(out, "lgs-engine 1 squares.rs squares blocks")?,
            ["reset"] => {
                cells.clear();
                cell_of.clear();
            }
            ["add", name, i, j, block, ..] => {
                let cell = (i.parse().unwrap(), j.parse().unwrap());
                cells.insert(cell, block.to_string());
                cell_of.insert(name.to_string(), cell);
            }
            ["remove", name] => {
                cells.remove(&cell_of.remove(name).unwrap());
            }
            ["commit"] => outline(&cells, &mut out)?,
            _ => {}
        }
        out.flush()?;
    }
    Ok(())
}
