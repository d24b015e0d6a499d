package tellosimulator.scenery.paint;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.zip.DataFormatException;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.Inflater;
import tellosimulator.scenery.Texture;

/**
 * A square picture that was painted before and comes with the program as a resource: blue, green,
 * red and alpha of each pixel, row by row, deflated. For any thread.
 *
 * @param owner a class in whose package the resource is
 * @param name of the resource, without its ending
 * @param size its edge [pixels]
 */
public record PreparedTile(Class<?> owner, String name, int size) {

  /** Read when it is first looked at; painted if the resource is not there. */
  public Texture texture(Supplier<Tile.Look> look) {
    return Texture.painted(size, size, () -> read().orElseGet(() -> Tile.pixels(size, look.get())));
  }

  /** The name of the resource's file. */
  public String file() {
    return name + ".bgra.deflated";
  }

  private Optional<int[]> read() {
    try (InputStream resource = owner.getResourceAsStream(file())) {
      if (resource == null) {
        return Optional.empty();
      }
      int[] pixels = new int[size * size];
      byte[] bytes = inflated(resource.readAllBytes(), Integer.BYTES * pixels.length);
      ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().get(pixels);
      return Optional.of(pixels);
    } catch (IOException | DataFormatException e) {
      throw new IllegalStateException(file() + " in the program's jar cannot be read", e);
    }
  }

  /** All at once, which takes half as long as by a stream. */
  private static byte[] inflated(byte[] deflated, int length)
      throws DataFormatException, EOFException {
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(deflated);
      byte[] bytes = new byte[length];
      if (inflater.inflate(bytes) < length) {
        throw new EOFException("it ends too early");
      }
      return bytes;
    } finally {
      inflater.end();
    }
  }

  /** Writes what the resource must hold. */
  public static void write(Texture texture, OutputStream to) throws IOException {
    int[] pixels = texture.argbArray();
    ByteBuffer bytes =
        ByteBuffer.allocate(Integer.BYTES * pixels.length).order(ByteOrder.LITTLE_ENDIAN);
    bytes.asIntBuffer().put(pixels);
    DeflaterOutputStream deflated = new DeflaterOutputStream(to);
    deflated.write(bytes.array());
    deflated.finish();
  }
}
