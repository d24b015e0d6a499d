package tellosimulator.view.model;

import tellosimulator.view.text.Language;
import tellosimulator.view.video.WindowVideo;

/**
 * The context of views that show the room of a running simulation or of a recording.
 *
 * @param simulation the simulation that the views show
 * @param language the language of the views' texts
 * @param ticker notifies the views when to update
 * @param video the video of the drones
 * @param marks the items that are drawn over the room
 */
public record SceneContext(
    FxSimulation simulation,
    Language language,
    UiTicker ticker,
    WindowVideo video,
    FxOverlayItems marks) {}
