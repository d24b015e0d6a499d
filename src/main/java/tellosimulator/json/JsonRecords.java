package tellosimulator.json;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Converts public records to JSON values and back without loss of precision. A record becomes an
 * object whose members are the components; if the declared type is a sealed interface, the object
 * also has the member {@code type}. Components may be records, numbers, strings, enums and
 * addresses, byte arrays (written as strings with one character per byte), and lists, sets, maps
 * and optionals of these. Only instances of the declared types are created, and each record
 * validates itself. Thread-safe.
 */
public final class JsonRecords {

  /**
   * The member that contains the simple class name of a record whose declared type is a sealed
   * interface.
   */
  private static final String TYPE = "type";

  /** A numeric IP address. Other forms are rejected, so that no host name is ever looked up. */
  private static final Pattern HOST =
      Pattern.compile("[0-9]{1,3}(\\.[0-9]{1,3}){3}|[0-9a-fA-F]*:[0-9a-fA-F:.]+(%[\\w.-]+)?");

  /**
   * The syntax of a number of type {@code long}. Such numbers are written as strings, because JSON
   * parsers might round large numbers.
   */
  private static final Pattern LARGE = Pattern.compile("-?[0-9]{1,19}");

  /** The infinite numbers, which are written as strings because JSON cannot represent them. */
  private static final Set<String> INFINITE = Set.of("Infinity", "-Infinity");

  private JsonRecords() {}

  /**
   * Converts a record to a value that {@link Json#text} formats.
   *
   * @param declared the class of the value, or a sealed interface that it implements
   */
  public static <T> Object write(Class<T> declared, T value) {
    return written(declared, value);
  }

  /**
   * Converts a value returned by {@link Json#value} to a record.
   *
   * @param declared the class of the record, or a sealed interface that it implements
   * @throws IllegalArgumentException if the value does not describe such a record; the message is
   *     one sentence
   */
  public static <T> T read(Class<T> declared, Object json) {
    return declared.cast(read(declared, json, declared.getSimpleName()));
  }

  // --- writing ---

  private static Object written(Type declared, Object value) {
    if (value instanceof Record one) {
      return members(one, raw(declared).isInterface());
    } else if (value instanceof Collection<?> many) {
      Type item = argument(declared, 0);
      return many.stream().map(each -> written(item, each)).toList();
    } else if (value instanceof Map<?, ?> map) {
      Map<String, Object> entries = new TreeMap<>();
      map.forEach((key, each) -> entries.put(word(key), written(argument(declared, 1), each)));
      return entries;
    } else if (value instanceof InetSocketAddress address) {
      return text(address);
    } else if (value instanceof byte[] bytes) {
      return new String(bytes, StandardCharsets.ISO_8859_1);
    } else if (value instanceof Boolean || value instanceof Integer || isFinite(value)) {
      return value;
    }
    return word(value); // for example, an infinite number or a long
  }

  private static boolean isFinite(Object value) {
    return value instanceof Double number && Double.isFinite(number);
  }

  private static String word(Object value) {
    return value instanceof Enum<?> constant ? constant.name() : value.toString();
  }

  private static Map<String, Object> members(Record value, boolean named) {
    Map<String, Object> members = new LinkedHashMap<>();
    if (named) {
      members.put(TYPE, value.getClass().getSimpleName());
    }
    for (RecordComponent component : value.getClass().getRecordComponents()) {
      Object content = content(component, value);
      if (content != null) {
        members.put(component.getName(), written(inner(component.getGenericType()), content));
      }
    }
    return members;
  }

  /** Returns the value of a component; null for an empty optional. */
  private static Object content(RecordComponent component, Record value) {
    try {
      return Json.content(component.getAccessor().invoke(value));
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException(value.getClass() + " is not public", e);
    }
  }

  /** Returns the type inside an optional; other types are returned unchanged. */
  private static Type inner(Type declared) {
    return raw(declared) == Optional.class ? argument(declared, 0) : declared;
  }

  private static Class<?> raw(Type type) {
    return (Class<?>) (type instanceof ParameterizedType generic ? generic.getRawType() : type);
  }

  private static Type argument(Type type, int index) {
    return ((ParameterizedType) type).getActualTypeArguments()[index];
  }

  // --- reading ---

  /**
   * Converts a JSON value to a declared type.
   *
   * @param json the value; null if it is missing
   * @param name the name of the value, for error messages
   */
  private static Object read(Type declared, Object json, String name) {
    Class<?> type = raw(declared);
    if (type == Optional.class) {
      return Optional.ofNullable(json).map(value -> read(argument(declared, 0), value, name));
    } else if (type == OptionalInt.class) {
      return json == null ? OptionalInt.empty() : OptionalInt.of(whole(json, name));
    } else if (type == OptionalDouble.class) {
      return json == null ? OptionalDouble.empty() : OptionalDouble.of(number(json, name));
    } else if (type == List.class) {
      return items(declared, json, name);
    } else if (type == Set.class) {
      return new LinkedHashSet<>(items(declared, json, name));
    } else if (type == Map.class) {
      return entries(declared, json, name);
    } else if (type.isRecord() || type.isSealed()) {
      return object(type, json, name);
    }
    return scalar(type, json, name);
  }

  private static Object scalar(Class<?> type, Object json, String name) {
    if (type == double.class || type == Double.class) {
      return number(json, name);
    } else if (type == int.class || type == Integer.class) {
      return whole(json, name);
    } else if (type == long.class || type == Long.class) {
      return large(json, name);
    } else if (type == boolean.class && json instanceof Boolean) {
      return json;
    } else if ((type == String.class || type == Object.class) && json instanceof String) {
      return json;
    } else if (type.isEnum() && json instanceof String word) {
      return constant(type, word, name);
    } else if (type == InetSocketAddress.class && json instanceof String address) {
      return socketAddress(address);
    } else if (type == byte[].class && json instanceof String text) {
      return text.getBytes(StandardCharsets.ISO_8859_1);
    }
    throw new IllegalArgumentException(name + " is not what is expected here");
  }

  private static int whole(Object json, String name) {
    if (json instanceof Long number && number.intValue() == number) {
      return number.intValue();
    }
    throw new IllegalArgumentException(name + " must be a whole number");
  }

  private static long large(Object json, String name) {
    if (json instanceof String digits && LARGE.matcher(digits).matches()) {
      return Long.parseLong(digits);
    }
    throw new IllegalArgumentException(name + " must be a whole number in quotes");
  }

  private static double number(Object json, String name) {
    if (json instanceof Number number) {
      return number.doubleValue();
    } else if (json instanceof String word && INFINITE.contains(word)) {
      return Double.parseDouble(word);
    }
    throw new IllegalArgumentException(name + " must be a number");
  }

  private static Object constant(Class<?> type, String word, String name) {
    return Arrays.stream(type.getEnumConstants())
        .filter(each -> ((Enum<?>) each).name().equals(word))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " is unknown: " + word));
  }

  private static List<Object> items(Type declared, Object json, String name) {
    if (!(json instanceof List<?> items)) {
      throw new IllegalArgumentException(name + " must be an array");
    }
    List<Object> read = new ArrayList<>(items.size());
    items.forEach(item -> read.add(read(argument(declared, 0), item, name)));
    return read;
  }

  private static Map<Object, Object> entries(Type declared, Object json, String name) {
    if (!(json instanceof Map<?, ?> members)) {
      throw new IllegalArgumentException(name + " must be an object");
    }
    Map<Object, Object> read = new LinkedHashMap<>();
    members.forEach(
        (key, value) ->
            read.put(
                read(argument(declared, 0), key, name), read(argument(declared, 1), value, name)));
    return read;
  }

  private static Object object(Class<?> declared, Object json, String name) {
    if (!(json instanceof Map<?, ?> members)) {
      throw new IllegalArgumentException(name + " must be an object");
    }
    Class<?> type =
        declared.isRecord()
            ? declared
            : records(declared)
                .filter(each -> each.getSimpleName().equals(members.get(TYPE)))
                .findFirst()
                .orElseThrow(
                    () ->
                        new IllegalArgumentException(
                            name + " is of an unknown type: " + members.get(TYPE)));
    RecordComponent[] components = type.getRecordComponents();
    Object[] values = new Object[components.length];
    Class<?>[] types = new Class<?>[components.length];
    for (int i = 0; i < components.length; i++) {
      types[i] = components[i].getType();
      String member = components[i].getName();
      values[i] = read(components[i].getGenericType(), members.get(member), member);
    }
    return made(type, types, values);
  }

  /**
   * Returns the records that a sealed interface permits, directly or through other sealed
   * interfaces.
   */
  private static Stream<Class<?>> records(Class<?> sealed) {
    return Arrays.stream(sealed.getPermittedSubclasses())
        .flatMap(each -> each.isRecord() ? Stream.of(each) : records(each));
  }

  private static Object made(Class<?> type, Class<?>[] types, Object[] values) {
    try {
      return type.getConstructor(types).newInstance(values);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof IllegalArgumentException refused) {
        throw refused;
      }
      throw new IllegalArgumentException(type.getSimpleName() + " cannot be made", e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException(type.getSimpleName() + " cannot be made", e);
    }
  }

  /** Formats an address as its numeric host, a colon and its port. */
  public static String text(InetSocketAddress address) {
    return address.getAddress().getHostAddress() + ":" + address.getPort();
  }

  /**
   * Parses a numeric host, a colon and a port, without looking up a host name.
   *
   * @throws IllegalArgumentException if the text does not have this form
   */
  public static InetSocketAddress socketAddress(String text) {
    int colon = text.lastIndexOf(':');
    String host = text.substring(0, Math.max(0, colon));
    if (!HOST.matcher(host).matches() || !text.substring(colon + 1).matches("[0-9]{1,5}")) {
      throw new IllegalArgumentException("expected host and port in numbers, found " + text);
    }
    try {
      int port = Integer.parseInt(text.substring(colon + 1));
      return new InetSocketAddress(InetAddress.getByName(host), port);
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException("there is no address " + host, e);
    }
  }
}
