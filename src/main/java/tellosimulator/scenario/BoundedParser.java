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

/** A parser that gives up before there is more in a text, or deeper, than a scenario needs. */
final class BoundedParser implements Parser {

  /** Most values in a file, which bounds the memory that they take. Decided. */
  private static final int MOST_VALUES = 400_000;

  /**
   * Deepest nesting, which bounds the stack that it takes. Decided: several times what is needed.
   */
  private static final int DEEPEST = 20;

  /** Most aliases of lists and mappings, which bounds the time to read them. Decided. */
  private static final int MOST_ALIASES = 50;

  /**
   * Longest key or value [characters], more than the longest text that means something. Decided.
   */
  private static final int LONGEST = 10_000;

  private final Parser parser;
  private final Set<Anchor> collections = new HashSet<>();
  private int depth;
  private int values;
  private int aliases;

  BoundedParser(Parser parser) {
    this.parser = parser;
  }

  /** There is more than is read. */
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
   * The next event.
   *
   * @throws ExceededException if it is one too many
   */
  @Override
  public Event next() {
    Event event = parser.next();
    values++;
    if (event instanceof CollectionStartEvent) {
      depth++;
    } else if (event instanceof CollectionEndEvent) {
      depth--;
    } else if (event instanceof ScalarEvent scalar && scalar.getValue().length() > LONGEST) {
      throw new ExceededException(
          event, Phrase.of("expected at most %d letters, found more", LONGEST));
    }
    if (depth > DEEPEST) {
      throw new ExceededException(
          event, Phrase.of("expected at most %d levels, found more", DEEPEST));
    }
    if (values > MOST_VALUES) {
      throw new ExceededException(
          event, Phrase.of("expected at most %d values, found more", MOST_VALUES));
    }
    count((event instanceof NodeEvent node ? node.getAnchor() : Optional.<Anchor>empty()), event);
    return event;
  }

  /** Counts aliases of lists and mappings. */
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
