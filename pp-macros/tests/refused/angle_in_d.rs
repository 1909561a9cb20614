pp_runtime::machine! {
    pub struct Table;
    chain: C B | X Y Z;
    dims = { d: 150.0, alpha: -45 deg };
    d = (0, 0, d + alpha);
}

fn main() {}
