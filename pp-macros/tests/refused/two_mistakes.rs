pp_runtime::machine! {
    pub struct Table;
    chain: C B | X Y Z;
    d = (0, 0, height);
    limits = { B: 110..-5 };
}

fn main() {}
