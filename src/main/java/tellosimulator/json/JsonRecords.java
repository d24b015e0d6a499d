package tellosimulator.json;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
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
 * Turns public records into values of JSON and back, without losing a bit. A record is an object
 * with its components as members; one of a sealed interface also says its {@code type}. Components
 * are records, numbers, texts, enums and addresses, and lists, sets, maps and optionals of these.
 * Nothing is made but what the declared types allow, and each record checks itself. For any thread.
 */
public final class JsonRecords {

  /** The member that says which record of a sealed interface it is. */
  private static final String TYPE = "type";

  /** An address in numbers, so that no name is ever looked up. */
  private static final Pattern HOST =
      Pattern.compile("[0-9]{1,3}(\\.[0-9]{1,3}){3}|[0-9a-fA-F]*:[0-9a-fA-F:.]+(%[\\w.-]+)?");

  /** A number of which JSON might keep the first digits alone. */
  private static final Pattern LARGE = Pattern.compile("-?[0-9]{1,19}");

  /** Numbers that JSON does not have. */
  private static final Set<String> INFINITE = Set.of("Infinity", "-Infinity");

  private JsonRecords() {}

  /**
   * A record as a value that {@link Json#text} writes.
   *
   * @param declared its class, or a sealed interface that it implements
   */
  public static <T> Object write(Class<T> declared, T value) {
    return written(declared, value);
  }

  /**
   * The record that a value of {@link Json#value} says.
   *
   * @param declared its class, or a sealed interface that it implements
   * @throws IllegalArgumentException with a sentence, if it says none
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
      return address.getAddress().getHostAddress() + ":" + address.getPort();
    } else if (value instanceof Boolean || value instanceof Integer || isFinite(value)) {
      return value;
    }
    return word(value); // such as an infinite number, or one that only a long holds
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

  /** That of a component; null for an empty optional. */
  private static Object content(RecordComponent component, Record value) {
    try {
      Object content = component.getAccessor().invoke(value);
      if (content instanceof Optional<?> optional) {
        return optional.orElse(null);
      } else if (content instanceof OptionalInt optional) {
        return optional.isPresent() ? optional.getAsInt() : null;
      } else if (content instanceof OptionalDouble optional) {
        return optional.isPresent() ? optional.getAsDouble() : null;
      }
      return content;
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException(value.getClass() + " is not public", e);
    }
  }

  /** What an optional holds; any other type itself. */
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
   * @param json null if there is nothing
   * @param name of what is read, for a sentence
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

  /** The records that a sealed interface permits, at any depth. */
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

  /**
   * Host and port, in numbers.
   *
   * @throws IllegalArgumentException if it is none
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
