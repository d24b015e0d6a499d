package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Function;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.fault.Fault;
import tellosimulator.fault.Fault.AfterCommand;
import tellosimulator.fault.Fault.AfterTakeoff;
import tellosimulator.fault.Fault.AtOnce;
import tellosimulator.fault.Fault.Begin;
import tellosimulator.fault.Fault.Span;
import tellosimulator.fault.Fault.Target;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.FaultParameter;
import tellosimulator.fault.FaultText;
import tellosimulator.fault.FaultTextException;
import tellosimulator.fault.LinkDirection;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.Codec.Composed;
import tellosimulator.words.Phrase;

/**
 * Codec of a fault. A fault is read from one line of text or from a mapping with the same words,
 * and is always written as a line.
 */
final class FaultCodec implements Codec<Fault> {

  /** Maximum length of a line [characters]. Decided: enough for all parts of a fault. */
  private static final int LONGEST = 300;

  private final FaultMapping mapping = new FaultMapping();

  @Override
  public Optional<Fault> read(Node node, Context context) {
    Optional<Fault> read =
        node instanceof MappingNode ? mapping.read(node, context) : line(node, context);
    OptionalInt drone = read.map(fault -> fault.target().drone()).orElse(OptionalInt.empty());
    if (drone.isPresent() && drone.getAsInt() > context.drones()) {
      return context
          .diagnostics()
          .add(
              node,
              Phrase.of(
                  "there is no drone %d, the drones are 1 to %d",
                  drone.getAsInt(), context.drones()));
    }
    return read;
  }

  private static Optional<Fault> line(Node node, Context context) {
    Optional<String> text = Scalars.text(node).filter(line -> line.length() <= LONGEST);
    if (text.isEmpty()) {
      return context
          .diagnostics()
          .expected(Phrase.of("a fault such as %s", "loss state 20%"), node);
    }
    return told(node, context, () -> Fault.of(text.get()));
  }

  /** Creates a value, or throws a {@link FaultTextException} if the arguments are invalid. */
  @FunctionalInterface
  private interface Attempt<T> {
    T make();
  }

  private static <T> Optional<T> told(Node node, Context context, Attempt<T> attempt) {
    try {
      return Optional.of(attempt.make());
    } catch (FaultTextException e) {
      return context.diagnostics().add(node, e.phrase());
    }
  }

  @Override
  public Node write(Fault fault, Path folder) {
    return Yaml.text(fault.text());
  }

  @Override
  public Map<String, Object> schema(Map<String, Object> definitions) {
    String kinds = String.join("|", FaultKind.byWord().keySet());
    return Codec.object(
        "anyOf",
        List.of(
            Codec.object(
                "type", "string", "maxLength", LONGEST, "pattern", "^(" + kinds + ")( |$)"),
            mapping.schema(definitions)));
  }

  /** Codec of a fault in the form of a mapping. */
  private static final class FaultMapping extends RecordCodec<Fault> {

    private final Field<Fault, FaultKind> kind =
        key("fault", "Faults.").need(new WordCodec<>(FaultKind.byWord()), Fault::kind);
    private final Field<Fault, Set<LinkDirection>> direction =
        key("direction", "Direction over the link. Default: all directions.")
            .optional(directions(), FaultMapping::unwritten);
    private final Map<FaultParameter, Field<Fault, Double>> parameters =
        new EnumMap<>(FaultParameter.class);
    private final Field<Fault, Integer> drone =
        key("drone", "Number of the drone. Default: all drones.")
            .optional(
                Scalars.count(
                    Phrase.of("the number of a drone from 1 to %d", AddressPlan.MOST_DRONES),
                    1,
                    AddressPlan.MOST_DRONES),
                FaultMapping::unwritten);
    private final Field<Fault, Double> at =
        key("at", "Time of its beginning, after the first takeoff. Default: immediately.")
            .optional(quantity(word -> FaultText.time(word, "at")), FaultMapping::unwritten);
    private final Field<Fault, String> after =
        key("after", "Beginning of the command after which it starts.")
            .optional(Scalars.LINE, FaultMapping::unwritten);
    private final Field<Fault, Integer> nth =
        key("nth", "Number of that command's occurrence, from 1.")
            .optional(
                Scalars.count(
                    Phrase.of("a number from 1 to %d", FaultText.HIGHEST_NTH),
                    1,
                    FaultText.HIGHEST_NTH),
                FaultMapping::unwritten);
    private final Field<Fault, Double> duration =
        key("for", "Duration. Default: unlimited.")
            .optional(quantity(word -> FaultText.time(word, "for")), FaultMapping::unwritten);

    FaultMapping() {
      super("fault", Phrase.of("a fault"), "Something that goes wrong, with units as in \"20%\".");
      for (FaultParameter parameter : FaultParameter.values()) {
        parameters.put(
            parameter,
            key(parameter.word(), capitalized(parameter.words()))
                .optional(
                    quantity(word -> FaultText.quantity(parameter, word)),
                    FaultMapping::unwritten));
      }
      add(Case.with("after").excludes("at"));
      add(Case.without("after").excludes("nth"));
      checked(this::check);
      made(this::make);
    }

    private static String capitalized(String words) {
      return Character.toUpperCase(words.charAt(0)) + words.substring(1) + ".";
    }

    /** Returns no value, since faults are written only as lines. */
    private static <V> Optional<V> unwritten(Fault fault) {
      return Optional.empty();
    }

    private void check(Entries in) {
      FaultKind chosen = in.get(kind);
      values(in)
          .forEach(
              (parameter, value) ->
                  attempt(
                      in,
                      parameters.get(parameter),
                      () -> new Fault(chosen, Target.ALL, Map.of(parameter, value), Span.ALWAYS)));
      if (in.find(direction).isPresent()) {
        attempt(in, direction, () -> new Fault(chosen, target(in), Map.of(), Span.ALWAYS));
      }
      if (in.sound()) {
        attempt(in, kind, () -> make(in));
      }
    }

    private static void attempt(Entries in, Field<Fault, ?> field, Attempt<Fault> attempt) {
      try {
        attempt.make();
      } catch (FaultTextException e) {
        in.diagnostic(field, e.phrase());
      }
    }

    private Map<FaultParameter, Double> values(Entries in) {
      Map<FaultParameter, Double> values = new EnumMap<>(FaultParameter.class);
      parameters.forEach(
          (parameter, field) -> in.find(field).ifPresent(value -> values.put(parameter, value)));
      return values;
    }

    private Target target(Entries in) {
      return new Target(in.findInt(drone), in.find(direction).orElse(Set.of()));
    }

    private Fault make(Entries in) {
      Begin begin = in.find(at).<Begin>map(AfterTakeoff::new).orElse(new AtOnce());
      if (in.find(after).isPresent()) {
        begin = new AfterCommand(in.get(after), in.find(nth).orElse(1));
      }
      Optional<Double> seconds = in.find(duration);
      OptionalDouble span =
          seconds.isPresent() ? OptionalDouble.of(seconds.get()) : OptionalDouble.empty();
      return new Fault(in.get(kind), target(in), values(in), new Span(begin, span));
    }
  }

  /** Returns the codec of a number with or without a unit, such as {@code 20%}. */
  private static Codec<Double> quantity(Function<String, Double> reader) {
    return new Composed<>(
        (node, context) -> {
          String word = Scalars.text(node).orElse("").replace(" ", "");
          return told(node, context, () -> reader.apply(word));
        },
        (value, folder) -> Yaml.number(value),
        definitions ->
            Codec.object(
                "anyOf",
                List.of(
                    Codec.object("type", "number", "minimum", 0),
                    Codec.object("type", "string", "pattern", "^[0-9.]+ ?[a-z%/]*$"))));
  }

  /** Returns the codec of one direction or a list of directions. */
  private static Codec<Set<LinkDirection>> directions() {
    WordCodec<LinkDirection> direction = WordCodec.of(LinkDirection.values());
    return new Composed<>(
        (node, context) -> {
          List<Node> words =
              node instanceof SequenceNode sequence ? sequence.getValue() : List.of(node);
          Set<LinkDirection> directions = EnumSet.noneOf(LinkDirection.class);
          int before = context.diagnostics().count();
          words.forEach(word -> direction.read(word, context).ifPresent(directions::add));
          return context.diagnostics().count() == before
              ? Optional.of(directions)
              : Optional.empty();
        },
        (value, folder) ->
            Yaml.text(String.join(" ", value.stream().map(LinkDirection::word).toList())),
        definitions -> {
          Map<String, Object> word = direction.schema(definitions);
          return Codec.object("anyOf", List.of(word, Codec.object("type", "array", "items", word)));
        });
  }
}
