package tellosimulator.view.settings;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;
import javafx.beans.property.Property;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.files.IoReason;

/**
 * Keeps properties in a file. What differs from its default is written soon after it changed; the
 * file is small, so this is done on the JavaFX thread, for which everything here is. Keys that
 * nobody binds stay as they were found: the player does not know all that the simulator remembers.
 */
public final class Settings {

  private static final Logger LOG = LoggerFactory.getLogger(Settings.class);

  /** How long nothing may have changed before it is written [ns]. Decided. */
  private static final long CALM_NANOS = 1_000_000_000;

  /** What a codec can have written; other lines of a damaged file are not kept. */
  private static final Pattern KEY = Pattern.compile("[a-z0-9.-]+");

  private static final Pattern TEXT = Pattern.compile("[\\p{Graph}&&[^\\\\]]+");

  /** A property that is kept. */
  private record Kept<T>(Property<T> property, T preset, SettingCodec<T> codec) {

    Optional<String> text() {
      T value = property.getValue();
      return value == null || Objects.equals(value, preset)
          ? Optional.empty()
          : Optional.of(codec.write().apply(value));
    }
  }

  private final SettingsFile file;
  private final Map<String, String> found;
  private final Map<String, Kept<?>> kept = new TreeMap<>();
  private boolean changed;
  private Optional<Long> changedNanos = Optional.empty();
  private boolean complained;

  private Settings(SettingsFile file, Map<String, String> found) {
    this.file = file;
    this.found = new HashMap<>(found);
  }

  /** Where this system keeps such files for this user. */
  public static Path file() {
    return SettingsFile.usual();
  }

  /** What is in a file; nothing if there is none, or if it cannot be read. */
  public static Settings load(Path path) {
    SettingsFile file = new SettingsFile(path);
    try {
      return new Settings(file, file.read());
    } catch (IOException e) {
      LOG.warn("The settings were not read, {}: {}.", path, IoReason.ofReading(e));
      return new Settings(file, Map.of());
    }
  }

  /** Whether nothing is remembered, as at the first start. */
  public boolean isNew() {
    return found.isEmpty();
  }

  /**
   * Gives a property the value that the file has for it, and keeps its value from now on.
   *
   * @param property whose present value is the default
   */
  public <T> void bind(String key, Property<T> property, SettingCodec<T> codec) {
    if (kept.put(key, new Kept<>(property, property.getValue(), codec)) != null) {
      throw new IllegalArgumentException("key is " + key + ", but that is bound already");
    }
    String text = found.get(key);
    if (text != null) {
      codec.read().apply(text).ifPresentOrElse(property::setValue, () -> complain(key, codec));
    }
    property.addListener((observed, before, now) -> noteChange());
  }

  /** Lets go of a property; who binds the key next gets its value. */
  public void unbind(String key) {
    Kept<?> before = kept.remove(key);
    if (before != null) {
      before.text().ifPresentOrElse(text -> found.put(key, text), () -> found.remove(key));
    }
  }

  private void complain(String key, SettingCodec<?> codec) {
    LOG.warn(
        "{}: {} is \"{}\", but must be {}; the default is used.",
        file.path(),
        key,
        shortened(found.get(key)),
        codec.allowed());
  }

  private static String shortened(String text) {
    String line = text.replaceAll("\\p{Cntrl}", "?");
    return line.length() > 40 ? line.substring(0, 40) + "…" : line;
  }

  private void noteChange() {
    changed = true;
    changedNanos = Optional.empty();
  }

  /**
   * Writes what changed, when nothing has changed for a while; to be called at each beat.
   *
   * @param nanos the beat's time [ns]
   */
  public void beat(long nanos) {
    if (!changed) {
      return;
    }
    if (changedNanos.isEmpty()) {
      changedNanos = Optional.of(nanos);
    } else if (nanos - changedNanos.get() >= CALM_NANOS) {
      save();
    }
  }

  /** Writes what changed, now; to be called when the window closes. */
  public void save() {
    if (!changed) {
      return;
    }
    changed = false;
    SortedMap<String, String> texts = unbound();
    kept.forEach((key, value) -> value.text().ifPresent(text -> texts.put(key, text)));
    try {
      file.write(texts);
    } catch (IOException e) {
      complainOnce(e);
    }
  }

  /** What was found and belongs to nobody who is there now. */
  private SortedMap<String, String> unbound() {
    SortedMap<String, String> texts = new TreeMap<>(found);
    texts.keySet().removeAll(kept.keySet());
    texts.keySet().removeIf(key -> !KEY.matcher(key).matches());
    texts.values().removeIf(text -> !TEXT.matcher(text).matches());
    return texts;
  }

  private void complainOnce(IOException e) {
    if (!complained) {
      complained = true;
      LOG.warn("The settings cannot be kept in {}: {}.", file.path(), IoReason.of(e));
    }
  }
}
