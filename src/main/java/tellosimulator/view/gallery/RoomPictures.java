package tellosimulator.view.gallery;

import java.util.LinkedHashMap;
import java.util.Map;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.image.Image;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.scenario.Gallery;
import tellosimulator.view.fx.FxTextures;

/**
 * The pictures of the scenarios that come with the program. On the first request, a separate thread
 * draws all pictures one after another. The pictures are cached. Confined to the JavaFX thread.
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
   * Returns the picture of a scenario; its value is null until the picture has been drawn.
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
    return FxTextures.image(RoomCamera.WIDTH, RoomCamera.HEIGHT, argb);
  }
}
