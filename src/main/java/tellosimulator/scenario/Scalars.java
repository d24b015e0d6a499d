package tellosimulator.scenario;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import org.snakeyaml.engine.v2.resolver.JsonScalarResolver;
import org.snakeyaml.engine.v2.resolver.ScalarResolver;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.words.Phrase;
import tellosimulator.words.Spelling;
import tellosimulator.world.Room;

/** Codecs of single values: texts, words, whole numbers, colours, addresses, places. */
final class Scalars {

  /** A line of text that is not empty. */
  static final Codec<String> LINE = new Line();

  static final Codec<Boolean> YES_OR_NO = new YesOrNo();
  static final Codec<Integer> COLOUR = new Colour();
  static final Codec<InetAddress> ADDRESS = new Address();

  /** An image file, seen from the folder of the scenario. */
  static final Codec<String> PICTURE = new Picture();

  /** Longest length of anything [cm]. */
  static final double LONGEST_CM = Room.LONGEST * 100;

  /** From the middle of something, in one direction or the other. */
  static final NumberCodec OFFSET = NumberCodec.length(-LONGEST_CM, LONGEST_CM);

  /** A place on the floor. */
  static final Codec<Vec3> FLOOR_POINT = new Vector(2, OFFSET);

  /** A place in the room. */
  static final Codec<Vec3> POINT = new Vector(3, OFFSET);

  static final Codec<Integer> PORT =
      count(Phrase.of("a port from 1 to 65535"), 1, AddressPlan.HIGHEST_PORT);

  private Scalars() {}

  /** A small whole number. */
  static Codec<Integer> count(Phrase expected, int least, int most) {
    return new Whole(expected, least, most).map(Math::toIntExact, Integer::longValue);
  }

  /** The values of an enum by their names in small letters. */
  @SafeVarargs
  static <E extends Enum<E>> Word<E> words(E... values) {
    NavigableMap<String, E> words = new TreeMap<>();
    for (E value : values) {
      words.put(value.name().toLowerCase(Locale.ROOT), value);
    }
    return new Word<>(words);
  }

  private static Optional<String> text(Node node) {
    return node instanceof ScalarNode scalar ? Optional.of(scalar.getValue()) : Optional.empty();
  }

  private record Line() implements Codec<String> {

    /** What YAML's usual schema takes a text for. */
    private static final ScalarResolver MEANING = new JsonScalarResolver();

    /** Longest text [characters]. Decided: a line or two. */
    private static final int LONGEST = 200;

    @Override
    public Optional<String> read(Node node, Reading reading) {
      if (node instanceof ScalarNode scalar && isText(scalar)) {
        String text = scalar.getValue().strip();
        if (oneLine(text)) {
          return Optional.of(text);
        }
      }
      Phrase expected = Phrase.of("a line of text of at most %d letters", LONGEST);
      return reading.mistakes().expected(expected, node);
    }

    /** Whether it is in quotation marks, or would not be a number or the like to other programs. */
    private static boolean isText(ScalarNode scalar) {
      return !scalar.isPlain() || MEANING.resolve(scalar.getValue(), true).equals(Tag.STR);
    }

    private static boolean oneLine(String text) {
      if (text.isEmpty() || text.length() > LONGEST) {
        return false;
      }
      for (int i = 0; i < text.length(); i++) {
        if (Character.isISOControl(text.charAt(i))) {
          return false;
        }
      }
      return true;
    }

    @Override
    public Node write(String value, Path folder) {
      return Yaml.text(value);
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object("type", "string", "minLength", 1, "maxLength", LONGEST);
    }
  }

  private record Picture() implements Codec<String> {

    @Override
    public Optional<String> read(Node node, Reading reading) {
      Optional<String> written = LINE.read(node, reading);
      Optional<Path> file = Optional.empty();
      if (written.isPresent()) {
        try {
          file = Optional.of(reading.folder().resolve(written.get()).normalize());
        } catch (InvalidPathException e) {
          file = Optional.empty(); // it names no file
        }
        if (file.isEmpty() || (reading.looked() && !Files.isRegularFile(file.get()))) {
          Object found = Mistakes.found(node);
          return reading
              .mistakes()
              .add(node, Phrase.of("expected the name of an image file, found no file %s", found));
        }
      }
      return file.map(Path::toString);
    }

    @Override
    public Node write(String file, Path folder) {
      Path path = Path.of(file).toAbsolutePath().normalize();
      Path base = folder.toAbsolutePath().normalize();
      boolean near = path.getRoot().equals(base.getRoot());
      return Yaml.text((near ? base.relativize(path) : path).toString().replace('\\', '/'));
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return LINE.schema(definitions);
    }
  }

  /** One of some words. */
  record Word<T>(NavigableMap<String, T> words) implements Codec<T> {

    Word(Map<String, T> words) {
      this(new TreeMap<>(words));
    }

    @Override
    public Optional<T> read(Node node, Reading reading) {
      Optional<String> written = text(node);
      Optional<T> meant = written.map(words::get);
      if (meant.isPresent()) {
        return meant;
      }
      String known = String.join(", ", words.keySet());
      Object found = Mistakes.found(node);
      Phrase wrong =
          written
              .flatMap(word -> Spelling.meant(word, words.keySet()))
              .map(
                  guess ->
                      Phrase.of(
                          "expected one of %s, found %s, did you mean %s?", known, found, guess))
              .orElseGet(() -> Phrase.of("expected one of %s, found %s", known, found));
      return reading.mistakes().add(node, wrong);
    }

    /** The word for a value. */
    String word(T value) {
      for (Map.Entry<String, T> entry : words.entrySet()) {
        if (entry.getValue().equals(value)) {
          return entry.getKey();
        }
      }
      throw new IllegalArgumentException("there is no word for " + value);
    }

    @Override
    public Node write(T value, Path folder) {
      return Yaml.text(word(value));
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object("enum", List.copyOf(words.keySet()));
    }
  }

  private record YesOrNo() implements Codec<Boolean> {

    private static final Word<Boolean> WORDS = new Word<>(Map.of("true", true, "false", false));

    @Override
    public Optional<Boolean> read(Node node, Reading reading) {
      return WORDS.read(node, reading);
    }

    @Override
    public Node write(Boolean value, Path folder) {
      return Yaml.plain(Tag.BOOL, value.toString());
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object("type", "boolean");
    }
  }

  /** A whole number. */
  record Whole(Phrase expected, long least, long most) implements Codec<Long> {

    private static final Pattern DIGITS = Pattern.compile("-?[0-9]{1,18}");

    @Override
    public Optional<Long> read(Node node, Reading reading) {
      if (node instanceof ScalarNode scalar
          && scalar.isPlain()
          && DIGITS.matcher(scalar.getValue()).matches()) {
        long value = Long.parseLong(scalar.getValue());
        if (value >= least && value <= most) {
          return Optional.of(value);
        }
      }
      return reading.mistakes().expected(expected, node);
    }

    @Override
    public Node write(Long value, Path folder) {
      return Yaml.plain(Tag.INT, value.toString());
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object("type", "integer", "minimum", least, "maximum", most);
    }
  }

  /** A colour as #rrggbb, or by its name. */
  private record Colour() implements Codec<Integer> {

    private static final Pattern HEX = Pattern.compile("#[0-9a-fA-F]{6}");

    /** Decided: as loud as painted wood. */
    private static final Word<Integer> NAMES =
        new Word<>(
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

    @Override
    public Optional<Integer> read(Node node, Reading reading) {
      String word = text(node).orElse("");
      if (HEX.matcher(word).matches()) {
        return Optional.of(Integer.parseInt(word.substring(1), 16));
      }
      Optional<Integer> named = Optional.ofNullable(NAMES.words().get(word));
      return named.isPresent()
          ? named
          : reading
              .mistakes()
              .expected(
                  Phrase.of(
                      "a colour such as \"#d9772b\", or one of %s",
                      String.join(", ", NAMES.words().keySet())),
                  node);
    }

    @Override
    public Node write(Integer rgb, Path folder) {
      return Yaml.text(
          NAMES.words().containsValue(rgb)
              ? NAMES.word(rgb)
              : String.format(Locale.ROOT, "#%06x", rgb));
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      List<Object> forms =
          List.of(
              NAMES.schema(definitions),
              Codec.object("type", "string", "pattern", "^" + HEX.pattern() + "$"));
      definitions.put(
          "colour",
          Codec.object(
              "description",
              "A colour: \"#rrggbb\" in quotation marks, or a name.",
              "anyOf",
              forms));
      return Codec.object("$ref", "#/$defs/colour");
    }
  }

  /** An IPv4 address of this machine. */
  private record Address() implements Codec<InetAddress> {

    private static final Pattern DOTTED =
        Pattern.compile("((25[0-5]|2[0-4][0-9]|1?[0-9]?[0-9])(\\.(?!$)|$)){4}");

    @Override
    public Optional<InetAddress> read(Node node, Reading reading) {
      Optional<InetAddress> address =
          text(node)
              .filter(word -> DOTTED.matcher(word).matches())
              .map(Address::parsed)
              .filter(AddressPlan::isOfOneHost);
      Phrase expected = Phrase.of("an address of this machine such as 127.0.0.2");
      return address.isPresent() ? address : reading.mistakes().expected(expected, node);
    }

    private static InetAddress parsed(String word) {
      try {
        return InetAddress.getByName(word);
      } catch (UnknownHostException e) {
        throw new IllegalArgumentException(word + " is no address", e);
      }
    }

    @Override
    public Node write(InetAddress value, Path folder) {
      return Yaml.text(value.getHostAddress());
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object(
          "type", "string", "format", "ipv4", "pattern", "^[0-9]{1,3}(\\.[0-9]{1,3}){3}$");
    }
  }

  /**
   * A vector of lengths: {@code [x, y]}, whose z is 0, or {@code [x, y, z]}.
   *
   * @param size 2 or 3
   */
  record Vector(int size, NumberCodec length) implements Codec<Vec3> {

    @Override
    public Optional<Vec3> read(Node node, Reading reading) {
      if (!(node instanceof SequenceNode sequence) || sequence.getValue().size() != size) {
        String names = size == 2 ? "[x, y]" : "[x, y, z]";
        return reading
            .mistakes()
            .expected(
                Phrase.of(
                    "%s in cm, each from %s to %s",
                    names, NumberCodec.plain(length.least()), NumberCodec.plain(length.most())),
                node);
      }
      double[] lengths = new double[3];
      boolean sound = true;
      for (int i = 0; i < size; i++) {
        Optional<Double> read = length.read(sequence.getValue().get(i), reading);
        sound &= read.isPresent();
        lengths[i] = read.orElse(0.0);
      }
      return sound ? Optional.of(new Vec3(lengths[0], lengths[1], lengths[2])) : Optional.empty();
    }

    @Override
    public Node write(Vec3 value, Path folder) {
      List<Node> lengths = new ArrayList<>();
      lengths.add(length.write(value.x(), folder));
      lengths.add(length.write(value.y(), folder));
      if (size == 3) {
        lengths.add(length.write(value.z(), folder));
      }
      return new SequenceNode(Tag.SEQ, lengths, FlowStyle.FLOW);
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return Codec.object(
          "type", "array", "minItems", size, "maxItems", size, "items", length.schema(definitions));
    }
  }
}
