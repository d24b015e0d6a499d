package tellosimulator.scenery.room;

import java.util.function.Function;

/** Makes a value of a key, and keeps it until another key comes. For one thread at a time. */
final class Latest<K, V> {

  private final Function<K, V> maker;
  private K key;
  private V value;

  Latest(Function<K, V> maker) {
    this.maker = maker;
  }

  V of(K newKey) {
    if (!newKey.equals(key)) {
      value = maker.apply(newKey);
      key = newKey;
    }
    return value;
  }
}
