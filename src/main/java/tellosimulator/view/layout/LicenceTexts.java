package tellosimulator.view.layout;

import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import tellosimulator.files.IoReason;

/** The notice of the program and the licences that it names, as they lie in the jar. */
final class LicenceTexts {

  /** The notice, in the jar. */
  static final String NOTICE = "META-INF/NOTICE";

  /** How the notice names a licence. */
  private static final Pattern NAMED = Pattern.compile("META-INF/(?:LICENSE|licenses/[\\w.-]*\\w)");

  /** Other jars have files of the same names; ours begin, or go on, with one of these. */
  private static final List<String> OURS = List.of("Tello Simulator", "Apache License");

  private LicenceTexts() {}

  /** The notice, then each licence that it names, by their paths. */
  static Map<String, String> all() {
    Map<String, String> texts = new LinkedHashMap<>();
    read(NOTICE)
        .ifPresent(
            notice -> {
              texts.put(NOTICE, notice);
              NAMED
                  .matcher(notice)
                  .results()
                  .map(result -> result.group())
                  .forEach(path -> read(path).ifPresent(text -> texts.put(path, text)));
            });
    return Collections.unmodifiableMap(texts);
  }

  private static Optional<String> read(String path) {
    ClassLoader loader = LicenceTexts.class.getClassLoader();
    boolean ambiguous = !path.contains("licenses/");
    try {
      for (URL url : Collections.list(loader.getResources(path))) {
        String text = read(url);
        if (!ambiguous || OURS.stream().anyMatch(text.strip()::startsWith)) {
          return Optional.of(text);
        }
      }
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(IoReason.of(e).toString());
    }
  }

  private static String read(URL url) throws IOException {
    try (InputStream in = url.openStream()) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
