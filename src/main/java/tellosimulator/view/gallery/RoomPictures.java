package tellosimulator.view.gallery;

import java.util.LinkedHashMap;
import java.util.Map;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.image.Image;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.scenario.Gallery;

/**
 * Pictures of the scenarios that come with the program. A thread of its own draws all of them, one
 * after the other, once the first one is asked for; they are kept. For the JavaFX thread.
 */
public final class RoomPictures {

  private static final ErrorPolicy FAILED = ErrorPolicy.finish("The scenarios could not be drawn");

  private final Map<String, ReadOnlyObjectWrapper<Image>> pictures = new LinkedHashMap<>();
  private boolean begun;

  public RoomPictures() {
    for (String name : Gallery.NAMES) {
      pictures.put(name, new ReadOnlyObjectWrapper<>(this, name));
    }
  }

  /**
   * The picture of a scenario; null until it is drawn.
   *
   * @param name one of {@link Gallery#NAMES}
   */
  ReadOnlyObjectProperty<Image> picture(String name) {
    if (!begun) {
      begun = true;
      Worker.once("room-pictures", FAILED, this::drawAll);
    }
    return pictures.get(name).getReadOnlyProperty();
  }

  private void drawAll() {
    RoomCamera camera = new RoomCamera();
    for (String name : Gallery.NAMES) {
      Gallery.find(name)
          .map(camera::picture)
          .ifPresent(argb -> Platform.runLater(() -> pictures.get(name).set(image(argb))));
    }
  }

  private static Image image(int[] argb) {
    WritableImage image = new WritableImage(RoomCamera.WIDTH, RoomCamera.HEIGHT);
    image
        .getPixelWriter()
        .setPixels(
            0,
            0,
            RoomCamera.WIDTH,
            RoomCamera.HEIGHT,
            PixelFormat.getIntArgbInstance(),
            argb,
            0,
            RoomCamera.WIDTH);
    return image;
  }
}
