package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import tellosimulator.scenario.Diagnostic.Place;
import tellosimulator.words.Phrase;

/**
 * Codec of a list in which each item starts a new line. Invalid items are reported and left out.
 *
 * @param most maximum number of items
 */
record ListCodec<T>(Codec<T> codec, int most) implements Codec<List<ListCodec.Item<T>>> {

  /**
   * An item of a list.
   *
   * @param number the number of the item in the file, from 1
   * @param place the position of the item in the file
   * @param drawn whether the item contains ranges
   */
  record Item<T>(T value, int number, Place place, boolean drawn) {

    /** Returns items for values that are not in a file yet. */
    static <T> List<Item<T>> of(List<T> values) {
      List<Item<T>> items = new ArrayList<>(values.size());
      for (T value : values) {
        items.add(new Item<>(value, items.size() + 1, Place.WHOLE, false));
      }
      return items;
    }

    static <T> List<T> values(List<Item<T>> items) {
      List<T> values = new ArrayList<>(items.size());
      for (Item<T> item : items) {
        values.add(item.value);
      }
      return values;
    }

    /** Returns a copy of this item with another value. */
    <U> Item<U> with(U other) {
      return new Item<>(other, number, place, drawn);
    }
  }

  @Override
  public Optional<List<Item<T>>> read(Node node, Context context) {
    if (!(node instanceof SequenceNode sequence)) {
      return context
          .diagnostics()
          .add(node, Phrase.of("expected a list, found %s", Diagnostics.found(node)));
    }
    List<Node> nodes = sequence.getValue();
    if (nodes.size() > most) {
      return context
          .diagnostics()
          .add(node, Phrase.of("expected a list of at most %d, found %d", most, nodes.size()));
    }
    List<Item<T>> items = new ArrayList<>(nodes.size());
    for (int i = 0; i < nodes.size(); i++) {
      Optional<T> value = codec.read(nodes.get(i), context);
      if (value.isPresent()) {
        boolean drawn = context.draw().varies(nodes.get(i));
        items.add(new Item<>(value.get(), i + 1, Diagnostics.place(nodes.get(i)), drawn));
      }
    }
    return Optional.of(items);
  }

  @Override
  public Node write(List<Item<T>> items, Path folder) {
    List<Node> nodes = new ArrayList<>();
    for (Item<T> item : items) {
      nodes.add(codec.write(item.value(), folder));
    }
    return new SequenceNode(Tag.SEQ, nodes, FlowStyle.BLOCK);
  }

  @Override
  public Map<String, Object> schema(Map<String, Object> definitions) {
    return Codec.object("type", "array", "items", codec.schema(definitions), "maxItems", most);
  }
}
