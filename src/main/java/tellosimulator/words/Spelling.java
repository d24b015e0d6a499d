package tellosimulator.words;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Suggests a known word for a misspelt one. */
public final class Spelling {

  /**
   * Number of letters in a word for each error that is allowed in it. Decided: at most about a
   * third of the letters may be wrong.
   */
  private static final int LETTERS_PER_SLIP = 3;

  /**
   * Maximum length of a word for which a suggestion is made [characters]. Decided: it limits the
   * time of a comparison, which grows with the square of the length.
   */
  private static final int LONGEST = 40;

  private Spelling() {}

  /**
   * Returns the known word that is nearest to the written word; empty if none is near enough. In
   * the written word, case is ignored, and underscores and spaces count as hyphens.
   *
   * @param known words in lower case, with hyphens
   */
  public static Optional<String> meant(String written, Collection<String> known) {
    if (written.length() > LONGEST) {
      return Optional.empty();
    }
    String lower = written.toLowerCase(Locale.ROOT).replace('_', '-').replace(' ', '-');
    Optional<String> meant = Optional.empty();
    int fewest = Integer.MAX_VALUE;
    for (String word : known) {
      int most = Math.min((word.length() + 1) / LETTERS_PER_SLIP, fewest - 1);
      boolean comparable =
          word.length() <= LONGEST && Math.abs(word.length() - lower.length()) <= most;
      int slips = comparable ? slips(lower, word) : Integer.MAX_VALUE;
      if (slips <= most) {
        fewest = slips;
        meant = Optional.of(word);
      }
    }
    return meant;
  }

  /**
   * Returns a suggestion for the end of a sentence.
   *
   * @param otherwise the end of the sentence if no known word is near enough
   */
  public static String hint(String written, Collection<String> known, String otherwise) {
    return meant(written, known).map(word -> ", did you mean " + word + "?").orElse(otherwise);
  }

  /**
   * Returns the number of extra, missing, wrong and transposed letters: the restricted
   * Damerau-Levenshtein distance.
   */
  static int slips(String written, String word) {
    int[][] slips = new int[written.length() + 1][word.length() + 1];
    for (int i = 0; i <= written.length(); i++) {
      for (int j = 0; j <= word.length(); j++) {
        slips[i][j] = i == 0 || j == 0 ? i + j : fewest(slips, written, word, i, j);
      }
    }
    return slips[written.length()][word.length()];
  }

  private static int fewest(int[][] slips, String written, String word, int i, int j) {
    boolean same = written.charAt(i - 1) == word.charAt(j - 1);
    int fewest =
        Math.min(
            slips[i - 1][j - 1] + (same ? 0 : 1),
            Math.min(slips[i - 1][j] + 1, slips[i][j - 1] + 1));
    boolean swapped =
        i > 1
            && j > 1
            && written.charAt(i - 1) == word.charAt(j - 2)
            && written.charAt(i - 2) == word.charAt(j - 1);
    return swapped ? Math.min(fewest, slips[i - 2][j - 2] + 1) : fewest;
  }
}
