//! Random numbers that are the same on every platform and in every version (SplitMix64).

/// A stream of random numbers.
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// The stream of a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [0, 1), with 53 random bits.
    pub fn unit(&mut self) -> f64 {
        #[allow(clippy::cast_precision_loss)] // 53 bits fit exactly
        let whole = (self.bits() >> 11) as f64;
        whole * (1.0 / 9_007_199_254_740_992.0)
    }

    /// A number in [lower, upper).
    pub fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.unit()
    }

    /// An integer in `0..count`.
    ///
    /// # Panics
    /// If `count` is zero.
    pub fn below(&mut self, count: usize) -> usize {
        assert!(count > 0, "`count` is positive");
        usize::try_from(self.bits() % count as u64).unwrap_or(0)
    }

    /// True with the given probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// `1.0` or `-1.0`.
    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }

    /// A point of the unit sphere, uniform by area.
    pub fn direction(&mut self) -> [f64; 3] {
        let height = self.between(-1.0, 1.0);
        let (sin, cos) = self.between(0.0, core::f64::consts::TAU).sin_cos();
        let radius = (1.0 - height * height).sqrt();
        [radius * cos, radius * sin, height]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::Random;

    #[test]
    fn a_seed_gives_the_published_stream() {
        // First three outputs of SplitMix64 for the seed 1234567.
        let mut random = Random::new(1_234_567);
        let first: Vec<u64> = (0..3).map(|_| random.bits()).collect();
        assert_eq!(first, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }

    #[test]
    fn numbers_stay_in_their_interval() {
        let mut random = Random::new(7);
        for _ in 0..10_000 {
            let x = random.between(-2.0, 3.0);
            assert!((-2.0..3.0).contains(&x));
            let [i, j, k] = random.direction();
            assert_abs_diff_eq!(i * i + j * j + k * k, 1.0, epsilon = 1e-15);
            assert!(random.below(5) < 5);
        }
    }
}
