package tellosimulator.scenario;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.snakeyaml.engine.v2.common.Anchor;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.CollectionEndEvent;
import org.snakeyaml.engine.v2.events.CollectionStartEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.Event.ID;
import org.snakeyaml.engine.v2.events.NodeEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.parser.Parser;
import tellosimulator.scenario.Diagnostic.Place;
import tellosimulator.words.Phrase;

/** A parser that rejects texts with more values or deeper nesting than a scenario needs. */
final class BoundedParser implements Parser {

  /**
   * Maximum number of parser events in a file; bounds memory use. Decided: 10,000 boxes with all
   * their keys need 410,000.
   */
  private static final int MOST_VALUES = 500_000;

  /**
   * Maximum number of items of a list, or of keys and values of a mapping; bounds parsing time.
   * Decided: twice the maximum number of obstacles.
   */
  private static final int MOST_ENTRIES = 20_000;

  /** Maximum nesting depth; bounds stack use. Decided: several times the depth of any scenario. */
  private static final int DEEPEST = 20;

  /** Maximum number of aliases that refer to lists or mappings; bounds parsing time. Decided. */
  private static final int MOST_ALIASES = 50;

  /** Maximum length of a key or value [characters]. Decided: longer than any valid text. */
  private static final int LONGEST = 10_000;

  private final Parser parser;
  private final Set<Anchor> collections = new HashSet<>();

  /** The number of entries so far of each collection that is open. */
  private final int[] entries = new int[DEEPEST + 1];

  private int depth;
  private int values;
  private int aliases;

  BoundedParser(Parser parser) {
    this.parser = parser;
  }

  /** Thrown if a text exceeds a limit. */
  static final class ExceededException extends RuntimeException {

    private static final long serialVersionUID = 1;

    private final transient Place place;
    private final transient Phrase phrase;

    private ExceededException(Event event, Phrase phrase) {
      super(phrase.english());
      this.place = event.getStartMark().map(Diagnostics::place).orElse(Place.WHOLE);
      this.phrase = phrase;
    }

    Place place() {
      return place;
    }

    Phrase phrase() {
      return phrase;
    }
  }

  @Override
  public boolean checkEvent(ID id) {
    return parser.checkEvent(id);
  }

  @Override
  public Event peekEvent() {
    return parser.peekEvent();
  }

  @Override
  public boolean hasNext() {
    return parser.hasNext();
  }

  /**
   * Returns the next event.
   *
   * @throws ExceededException if the event exceeds a limit
   */
  @Override
  public Event next() {
    Event event = parser.next();
    values++;
    if (event instanceof NodeEvent && ++entries[depth] > MOST_ENTRIES) {
      throw new ExceededException(
          event, Phrase.of("expected at most %d entries, found more", MOST_ENTRIES));
    }
    if (event instanceof CollectionStartEvent) {
      depth++;
      if (depth > DEEPEST) {
        throw new ExceededException(
            event, Phrase.of("expected at most %d levels, found more", DEEPEST));
      }
      entries[depth] = 0;
    } else if (event instanceof CollectionEndEvent) {
      depth--;
    } else if (event instanceof ScalarEvent scalar && scalar.getValue().length() > LONGEST) {
      throw new ExceededException(
          event, Phrase.of("expected at most %d letters, found more", LONGEST));
    }
    if (values > MOST_VALUES) {
      throw new ExceededException(
          event, Phrase.of("expected at most %d values, found more", MOST_VALUES));
    }
    count((event instanceof NodeEvent node ? node.getAnchor() : Optional.<Anchor>empty()), event);
    return event;
  }

  /**
   * Records the anchor of a list or mapping, or counts an alias that refers to one.
   *
   * @throws ExceededException if there are too many such aliases
   */
  private void count(Optional<Anchor> anchor, Event event) {
    if (anchor.isEmpty()) {
      return;
    }
    if (event instanceof CollectionStartEvent) {
      collections.add(anchor.get());
    } else if (event instanceof AliasEvent && collections.contains(anchor.get())) {
      aliases++;
      if (aliases > MOST_ALIASES) {
        throw new ExceededException(
            event, Phrase.of("expected at most %d aliases, found more", MOST_ALIASES));
      }
    }
  }
}
