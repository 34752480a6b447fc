#ifndef WF_CMD_TREE_DRAW_H
#define WF_CMD_TREE_DRAW_H

/* windfirm tree draw: a picture of a model or a measured tree. Given: the command line behind "tree", argv[0]
 * = "draw". Returned: exit code. */
int wf_tree_draw(int argc, char **argv);
#endif
