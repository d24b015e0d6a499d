package tellosimulator.view.model;

import tellosimulator.view.text.Language;
import tellosimulator.view.video.WindowVideo;

/**
 * What views of the room are built with, be it of a running simulation or of a recording.
 *
 * @param simulation what they show
 * @param language in which they speak
 * @param pulse when they move on
 * @param video what the drones film
 * @param marks what is marked in them
 */
public record SceneContext(
    FxSimulation simulation, Language language, Pulse pulse, WindowVideo video, FxMarks marks) {}
