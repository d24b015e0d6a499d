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
import javafx.util.Subscription;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.files.IoReason;

/**
 * Stores properties in a file. Values that differ from their defaults are written shortly after a
 * change. The values of unbound keys stay as they were read, because the player does not bind all
 * settings of the simulator. Confined to the JavaFX thread; the file is so small that this thread
 * also writes it.
 */
public final class Settings {

  private static final Logger LOG = LoggerFactory.getLogger(Settings.class);

  /**
   * Time without a change after which the file is written [ns]. Decided: a quick succession of
   * changes is written once.
   */
  private static final long CALM_NANOS = 1_000_000_000;

  /** The syntax of keys. Lines with other keys, as in a damaged file, are dropped. */
  private static final Pattern KEY = Pattern.compile("[a-z0-9.-]+");

  private static final Pattern TEXT = Pattern.compile("[\\p{Graph}&&[^\\\\]]+");

  /** A property that is stored. */
  private record BoundSetting<T>(Property<T> property, T preset, SettingCodec<T> codec) {

    Optional<String> text() {
      T value = property.getValue();
      return value == null || Objects.equals(value, preset)
          ? Optional.empty()
          : Optional.of(codec.write().apply(value));
    }
  }

  private final SettingsFile file;
  private final Map<String, String> found;
  private final Map<String, BoundSetting<?>> kept = new TreeMap<>();
  private boolean changed;
  private Optional<Long> changedNanos = Optional.empty();
  private boolean complained;

  private Settings(SettingsFile file, Map<String, String> found) {
    this.file = file;
    this.found = new HashMap<>(found);
  }

  /** Returns the path of the settings file for this user on this system. */
  public static Path file() {
    return SettingsFile.usual();
  }

  /** Loads a file. The settings are empty if the file does not exist or cannot be read. */
  public static Settings load(Path path) {
    SettingsFile file = new SettingsFile(path);
    try {
      return new Settings(file, file.read());
    } catch (IOException e) {
      LOG.warn("The settings were not read, {}: {}.", path, IoReason.ofReading(e));
      return new Settings(file, Map.of());
    }
  }

  /** Returns whether no settings are stored, as at the first start. */
  public boolean isNew() {
    return found.isEmpty();
  }

  /**
   * Sets a property to the stored value, if there is a valid one, and stores its changes from then
   * on.
   *
   * @param property a property whose current value is the default
   * @return a subscription that unbinds the property; the next property that is bound to the key
   *     gets the same value
   */
  public <T> Subscription bind(String key, Property<T> property, SettingCodec<T> codec) {
    if (kept.put(key, new BoundSetting<>(property, property.getValue(), codec)) != null) {
      throw new IllegalArgumentException("key is " + key + ", but that is bound already");
    }
    String text = found.get(key);
    if (text != null) {
      codec.read().apply(text).ifPresentOrElse(property::setValue, () -> complain(key, codec));
    }
    property.addListener((observed, before, now) -> noteChange());
    return () -> unbind(key);
  }

  void unbind(String key) {
    BoundSetting<?> before = kept.remove(key);
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
   * Writes changes once no further change has followed for a while. Must be called at each UI tick.
   *
   * @param nanos the time of the tick [ns]
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

  /** Writes changes immediately. Must be called when the window closes. */
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

  /** Returns the stored values of keys that are not bound at present. */
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
