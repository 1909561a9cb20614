pp_runtime::machine! {
    pub struct Table;
    chain: C B | X Y Z A;
}

fn main() {}
