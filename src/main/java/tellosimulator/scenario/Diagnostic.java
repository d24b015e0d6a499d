package tellosimulator.scenario;

import java.util.Comparator;
import tellosimulator.words.Phrase;
import tellosimulator.words.Translation;

/**
 * Something that is wrong in a file. Immutable.
 *
 * @param file its name as it was given
 * @param place where it is wrong
 * @param phrase what was expected and what was found
 */
public record Diagnostic(String file, Place place, Phrase phrase) {

  /**
   * A place in a file, as editors count.
   *
   * @param line from 1; 0 for the file as a whole
   * @param column from 1; 0 for the file as a whole
   */
  public record Place(int line, int column) implements Comparable<Place> {

    /** The file as a whole. */
    public static final Place WHOLE = new Place(0, 0);

    @Override
    public int compareTo(Place other) {
      return Comparator.comparingInt(Place::line)
          .thenComparingInt(Place::column)
          .compare(this, other);
    }
  }

  /** In a language: {@code room.yaml:12:7: expected a length in cm, found "abc"}. */
  public String in(Translation language) {
    String where = place.line() == 0 ? "" : ":" + place.line() + ":" + place.column();
    return file + where + ": " + phrase.in(language);
  }

  /** In English. */
  @Override
  public String toString() {
    return in(Translation.ENGLISH);
  }
}
