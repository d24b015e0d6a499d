package tellosimulator.endurance;

import java.util.ArrayList;
import java.util.List;

/** How the program is told that other machines may reach its drones. */
final class LanOptions {

  /** Empty where the program has no such option because it always listens everywhere. */
  private static final String LAN = System.getProperty("endurance.lan", "--lan");

  private LanOptions() {}

  /** These options, and that one. */
  static String[] with(String... options) {
    List<String> all = new ArrayList<>(List.of(options));
    if (!LAN.isEmpty()) {
      all.add(LAN);
    }
    return all.toArray(String[]::new);
  }
}
