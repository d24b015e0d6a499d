package tellosimulator.recording;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;

/** The fields of a state line that are one number. */
public final class StateNumbers {

  private static final Pattern NUMBER = Pattern.compile("-?\\d{1,9}([.]\\d{1,9})?");

  private StateNumbers() {}

  /**
   * Reads a state line.
   *
   * @param text such as {@code pitch:0;roll:0;yaw:-26;…}
   * @return values by their keys, in the order of the line; without what was damaged on its way
   */
  public static Map<String, Double> of(String text) {
    Map<String, Double> numbers = new LinkedHashMap<>();
    for (String field : text.strip().split(";", -1)) {
      int colon = field.indexOf(':');
      if (colon > 0 && NUMBER.matcher(field).region(colon + 1, field.length()).matches()) {
        numbers.put(field.substring(0, colon), Double.valueOf(field.substring(colon + 1)));
      }
    }
    return numbers;
  }
}
