//! Words of a text with the lines they stand on.

/// What is wrong with a text, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    /// Counted from one.
    pub(super) line: usize,
    pub(super) found: String,
    pub(super) expected: String,
}

/// Words of a text, taken one after the other; what follows `#` on a line is ignored.
#[derive(Debug)]
pub(super) struct Tokens<'t> {
    words: Vec<(&'t str, usize)>,
    at: usize,
    last_line: usize,
}

impl<'t> Tokens<'t> {
    pub(super) fn of(text: &'t str) -> Self {
        let lines = text.lines().enumerate();
        let words = lines.clone().flat_map(|(k, line)| {
            let line = line.split('#').next().unwrap_or("");
            line.split_whitespace().map(move |word| (word, k + 1))
        });
        Self {
            words: words.collect(),
            at: 0,
            last_line: lines.count().max(1),
        }
    }

    /// How many words are left.
    pub(super) fn left(&self) -> usize {
        self.words.len() - self.at
    }

    /// The next word, which stays.
    pub(super) fn peek(&self) -> Option<&'t str> {
        self.words.get(self.at).map(|(word, _)| *word)
    }

    /// The next word.
    pub(super) fn word(&mut self, what: &str) -> Result<&'t str, Fault> {
        let word = self.peek().ok_or_else(|| Fault {
            line: self.last_line,
            found: "the end of the file".to_owned(),
            expected: what.to_owned(),
        })?;
        self.at += 1;
        Ok(word)
    }

    /// Passes over the rest of the line on which the last word stands.
    pub(super) fn skip_line(&mut self) {
        let line = self.line();
        while self.words.get(self.at).is_some_and(|word| word.1 == line) {
            self.at += 1;
        }
    }

    /// The next word as a number of things.
    pub(super) fn count(&mut self, what: &str) -> Result<usize, Fault> {
        let word = self.word(what)?;
        word.parse()
            .map_err(|_| self.fault(format!("`{word}`"), what))
    }

    /// The next word as a finite number.
    pub(super) fn number(&mut self, what: &str) -> Result<f64, Fault> {
        let word = self.word(what)?;
        match word.parse() {
            Ok(number) if f64::is_finite(number) => Ok(number),
            _ => Err(self.fault(format!("`{word}`"), &format!("a finite number of {what}"))),
        }
    }

    /// The next `count` words as finite numbers.
    pub(super) fn numbers(&mut self, count: usize, what: &str) -> Result<Vec<f64>, Fault> {
        let left = self.left();
        if left < count {
            self.at = self.words.len();
            let expected = format!("{count} numbers of {what}");
            return Err(self.fault(format!("{left} more words"), &expected));
        }
        (0..count).map(|_| self.number(what)).collect()
    }

    /// A fault at the last word.
    pub(super) fn fault(&self, found: String, expected: &str) -> Fault {
        Fault {
            line: self.line(),
            found,
            expected: expected.to_owned(),
        }
    }

    fn line(&self) -> usize {
        let last = self.words.get(self.at.saturating_sub(1));
        last.map_or(1, |word| word.1)
    }
}
