pp_runtime::machine! {
    pub struct Table;
    chain: B C | X Y Z;
}

fn main() {}
