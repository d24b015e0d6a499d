package tellosimulator.scenario;

import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import org.snakeyaml.engine.v2.resolver.JsonScalarResolver;
import org.snakeyaml.engine.v2.resolver.ScalarResolver;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.Codec.Composed;
import tellosimulator.scenario.Codec.Context;
import tellosimulator.words.Phrase;

/** Codecs of single values, such as texts, whole numbers, colours, addresses and positions. */
final class Scalars {

  /** Maximum length of a text [characters]. Decided: one or two lines on a screen. */
  private static final int LONGEST_LINE = 200;

  /** Determines the type of a plain scalar according to the JSON schema of YAML 1.2. */
  private static final ScalarResolver MEANING = new JsonScalarResolver();

  static final Pattern DIGITS = Pattern.compile("-?[0-9]{1,18}");
  private static final Pattern HEX = Pattern.compile("#[0-9a-fA-F]{6}");

  /** Named colours, as {@code 0xrrggbb}. Decided: muted, like painted wood. */
  private static final WordCodec<Integer> COLOR_NAMES =
      new WordCodec<>(
          Map.of(
              "red", 0xc0392b,
              "orange", 0xd9772b,
              "yellow", 0xe1b12c,
              "green", 0x3d9a50,
              "blue", 0x2e6db4,
              "purple", 0x7d4fa0,
              "brown", 0x8a5a36,
              "white", 0xf2f2f2,
              "grey", 0x8c8c8c,
              "black", 0x262626));

  private static final WordCodec<Boolean> TRUTH =
      new WordCodec<>(Map.of("true", true, "false", false));

  /** Codec of a non-empty line of text. */
  static final Codec<String> LINE =
      scalar(
          Phrase.of("a line of text of at most %d letters", LONGEST_LINE),
          Scalars::line,
          Yaml::text,
          definitions -> Codec.object("type", "string", "minLength", 1, "maxLength", LONGEST_LINE));

  static final Codec<Boolean> YES_OR_NO =
      new Composed<>(
          TRUTH::read,
          (value, folder) -> Yaml.plain(Tag.BOOL, value.toString()),
          definitions -> Codec.object("type", "boolean"));

  /** Codec of a colour, written as #rrggbb or by its name. */
  static final Codec<Integer> COLOR =
      scalar(
          Phrase.of(
              "a colour such as \"#d9772b\", or one of %s",
              String.join(", ", COLOR_NAMES.words().keySet())),
          scalar -> color(scalar.getValue()),
          rgb ->
              COLOR_NAMES.words().containsValue(rgb)
                  ? COLOR_NAMES.write(rgb, Path.of(""))
                  : Yaml.text(String.format(Locale.ROOT, "#%06x", rgb)),
          Scalars::colorSchema);

  /** Codec of an IPv4 address of this machine. */
  static final Codec<InetAddress> ADDRESS =
      scalar(
          Phrase.of("an address of this machine such as 127.0.0.2"),
          scalar -> AddressPlan.parse(scalar.getValue()),
          address -> Yaml.text(address.getHostAddress()),
          definitions ->
              Codec.object(
                  "type", "string", "format", "ipv4", "pattern", "^[0-9]{1,3}(\\.[0-9]{1,3}){3}$"));

  /** Codec of an image file whose name is relative to the folder of the scenario file. */
  static final Codec<String> PICTURE =
      new Composed<>(Scalars::picture, Scalars::relative, LINE::schema);

  /** Codec of a coordinate in the room or on one of its surfaces, positive or negative. */
  static final NumberCodec OFFSET = NumberCodec.length(Quantity.OFFSET);

  /** Codec of a position on the floor. */
  static final Codec<Vec3> FLOOR_POINT = new NumberCodec.Vector(2, OFFSET);

  /** Codec of a position in the room. */
  static final Codec<Vec3> POINT = new NumberCodec.Vector(3, OFFSET);

  static final Codec<Integer> PORT =
      count(Phrase.of("a port from 1 to 65535"), 1, AddressPlan.HIGHEST_PORT);

  static final Codec<Long> SEED =
      whole(
          Phrase.of("a whole number of at most 18 digits"),
          -999_999_999_999_999_999L,
          999_999_999_999_999_999L);

  private Scalars() {}

  /** Returns a codec for a small whole number. */
  static Codec<Integer> count(Phrase expected, int least, int most) {
    return whole(expected, least, most).map(Math::toIntExact, Integer::longValue);
  }

  /** Returns a codec for a whole number. */
  static Codec<Long> whole(Phrase expected, long least, long most) {
    return scalar(
        expected,
        scalar ->
            Optional.of(scalar)
                .filter(ScalarNode::isPlain)
                .map(ScalarNode::getValue)
                .filter(word -> DIGITS.matcher(word).matches())
                .map(Long::valueOf)
                .filter(value -> value >= least && value <= most),
        value -> Yaml.plain(Tag.INT, value.toString()),
        definitions -> Codec.object("type", "integer", "minimum", least, "maximum", most));
  }

  static Optional<String> text(Node node) {
    return node instanceof ScalarNode scalar ? Optional.of(scalar.getValue()) : Optional.empty();
  }

  /**
   * Returns a codec of scalars.
   *
   * @param expected describes the valid values
   * @param meaning returns the value of a scalar; empty if the scalar is invalid
   */
  private static <T> Codec<T> scalar(
      Phrase expected,
      Function<ScalarNode, Optional<T>> meaning,
      Function<T, Node> writer,
      UnaryOperator<Map<String, Object>> describer) {
    return new Composed<>(
        (node, context) -> {
          Optional<T> value =
              node instanceof ScalarNode scalar ? meaning.apply(scalar) : Optional.empty();
          return value.isPresent() ? value : context.diagnostics().expected(expected, node);
        },
        (value, folder) -> writer.apply(value),
        describer);
  }

  /**
   * Returns the text of a scalar without spaces at its ends. Returns empty if the text is not a
   * valid line, or if it is not quoted and other programs would parse it as a number or another
   * type.
   */
  private static Optional<String> line(ScalarNode scalar) {
    boolean text = !scalar.isPlain() || MEANING.resolve(scalar.getValue(), true).equals(Tag.STR);
    return Optional.of(scalar.getValue().strip())
        .filter(line -> text && !line.isEmpty() && line.length() <= LONGEST_LINE)
        .filter(line -> line.chars().noneMatch(Character::isISOControl));
  }

  private static Optional<Integer> color(String word) {
    return HEX.matcher(word).matches()
        ? Optional.of(Integer.parseInt(word.substring(1), 16))
        : Optional.ofNullable(COLOR_NAMES.words().get(word));
  }

  private static Map<String, Object> colorSchema(Map<String, Object> definitions) {
    List<Object> forms =
        List.of(
            COLOR_NAMES.schema(definitions),
            Codec.object("type", "string", "pattern", "^" + HEX.pattern() + "$"));
    String description = "A colour: \"#rrggbb\" in quotation marks, or a name.";
    definitions.put("colour", Codec.object("description", description, "anyOf", forms));
    return Codec.object("$ref", "#/$defs/colour");
  }

  private static Optional<String> picture(Node node, Context context) {
    Optional<String> written = LINE.read(node, context);
    Optional<Path> file = Optional.empty();
    if (written.isPresent()) {
      try {
        file = Optional.of(context.folder().resolve(written.get()).normalize());
      } catch (InvalidPathException e) {
        file = Optional.empty(); // not a valid file name
      }
      if (file.isEmpty() || (context.looked() && !Files.isRegularFile(file.get()))) {
        Object found = Diagnostics.found(node);
        return context
            .diagnostics()
            .add(node, Phrase.of("expected the name of an image file, found no file %s", found));
      }
    }
    return file.map(Path::toString);
  }

  private static Node relative(String file, Path folder) {
    Path path = Path.of(file).toAbsolutePath().normalize();
    Path base = folder.toAbsolutePath().normalize();
    boolean near = path.getRoot().equals(base.getRoot());
    return Yaml.text((near ? base.relativize(path) : path).toString().replace('\\', '/'));
  }
}
