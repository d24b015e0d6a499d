package tellosimulator.scenario;

import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.Event.ID;
import org.snakeyaml.engine.v2.parser.Parser;
import tellosimulator.scenario.Mistake.Place;
import tellosimulator.words.Phrase;

/** Gives up before a text becomes more nodes, or deeper ones, than a scenario needs. */
final class BoundedParser implements Parser {

  /** Most values in a file, which bounds the memory that they take. Decided. */
  private static final int MOST_VALUES = 400_000;

  /**
   * Deepest nesting, which bounds the stack that it takes. Decided: several times what is needed.
   */
  private static final int DEEPEST = 20;

  private final Parser parser;
  private int depth;
  private int values;

  BoundedParser(Parser parser) {
    this.parser = parser;
  }

  /** There is more than is read. */
  static final class TooMuchException extends RuntimeException {

    private static final long serialVersionUID = 1;

    private final transient Place place;
    private final transient Phrase phrase;

    private TooMuchException(Event event, Phrase phrase) {
      super(phrase.english());
      this.place = event.getStartMark().map(Mistakes::place).orElse(Place.WHOLE);
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
  public Event next() {
    Event event = parser.next();
    ID id = event.getEventId();
    values++;
    if (id == ID.MappingStart || id == ID.SequenceStart) {
      depth++;
    } else if (id == ID.MappingEnd || id == ID.SequenceEnd) {
      depth--;
    }
    if (depth > DEEPEST) {
      throw new TooMuchException(
          event, Phrase.of("expected at most %d levels, found more", DEEPEST));
    }
    if (values > MOST_VALUES) {
      throw new TooMuchException(
          event, Phrase.of("expected at most %d values, found more", MOST_VALUES));
    }
    return event;
  }

  @Override
  public boolean hasNext() {
    return parser.hasNext();
  }

  @Override
  public Event peekEvent() {
    return parser.peekEvent();
  }

  @Override
  public boolean checkEvent(ID id) {
    return parser.checkEvent(id);
  }
}
