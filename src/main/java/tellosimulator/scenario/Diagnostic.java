package tellosimulator.scenario;

import java.util.Comparator;
import tellosimulator.words.Phrase;
import tellosimulator.words.Translation;

/**
 * An error in a file. Immutable.
 *
 * @param file the file's name as it was given
 * @param place the position of the error
 * @param phrase what was expected and what was found
 */
public record Diagnostic(String file, Place place, Phrase phrase) {

  /**
   * A position in a file, with the line and column that editors display.
   *
   * @param line the line, from 1; 0 for the file as a whole
   * @param column the column, from 1; 0 for the file as a whole
   */
  public record Place(int line, int column) implements Comparable<Place> {

    public static final Place WHOLE = new Place(0, 0);

    @Override
    public int compareTo(Place other) {
      return Comparator.comparingInt(Place::line)
          .thenComparingInt(Place::column)
          .compare(this, other);
    }
  }

  /**
   * Formats this error in a language, for example {@code room.yaml:12:7: expected a length in cm,
   * found "abc"}.
   */
  public String in(Translation language) {
    String where = place.line() == 0 ? "" : ":" + place.line() + ":" + place.column();
    return file + where + ": " + phrase.in(language);
  }

  /** Formats this error in English. */
  @Override
  public String toString() {
    return in(Translation.ENGLISH);
  }
}
