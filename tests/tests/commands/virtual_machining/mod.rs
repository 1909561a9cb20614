//! Virtual machining of whole jobs: the parts of the papers, and faults that are planted in a right one.

mod faults;
mod papers;
