package tellosimulator.video.camera;

import java.util.Map;
import java.util.WeakHashMap;
import java.util.function.Function;

/**
 * Things made of others, kept as long as these live. What is made must not hold what it is made of.
 * For any thread; what two threads want at the same time is made once.
 *
 * @param <K> what things are made of; only the very same is equal
 */
final class WeakCache<K, V> {

  private final Map<K, V> made = new WeakHashMap<>();
  private final Function<K, V> maker;

  WeakCache(Function<K, V> maker) {
    this.maker = maker;
  }

  synchronized V get(K key) {
    V value = made.get(key);
    if (value == null) {
      value = maker.apply(key);
      made.put(key, value);
    }
    return value;
  }

  /** How many things are kept. */
  synchronized int size() {
    return made.size();
  }
}
