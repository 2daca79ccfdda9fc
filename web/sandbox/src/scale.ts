// How large the world is for the physics. Marbles are small, and so a seam is large for them.
/** The side of a cell, in metres. */
export const cell = 0.25
/** Metres per second squared. */
export const gravity = 3
